# A sphere hits a plate at 200 m/s, with friction 0.1 (SI). Mesh: two_body_contact.g of NimbleSM's tests.
# Expected: both stay whole, the sphere is thrown back, energies balance.
#
# Run it beside the mesh: contactsim two_body.i two_body_contact.g
# {formulation = "face_face"} {friction = 0.1} {penalty = 1}
# {title = "two bodies"} {mesh = "two_body_contact.g"}
# {density = 7800} {bulk = 1.6e11} {shear = 0.8e11}
# {speed = 200} {way_x = 1} {way_y = 0} {way_z = 0} {end_time = 1e-4}
{include("two_bodies.inc")}
