# A cube slides along a beam, pressed down by its fall, with friction 0.3 (SI). Mesh: sliding_contact.g of
# NimbleSM's tests. Expected: friction takes energy as long as they touch, forces balance.
#
# Run it beside the mesh: contactsim sliding.i sliding_contact.g
# {formulation = "face_face"} {friction = 0.3} {penalty = 1}
# {title = "a block slides"} {mesh = "sliding_contact.g"}
# {density = 7800} {bulk = 1.6e11} {shear = 0.8e11}
# {speed = 20} {way_x = 0} {way_y = 1} {way_z = -0.1} {end_time = 5e-3}
{include("two_bodies.inc")}
