# One element hits another: block_2 flies at block_1 along x (SI). Mesh: two_element_contact.g of NimbleSM's tests.
# Expected: momentum stays, the bodies part again, energies balance to better than 0.1 %.
#
# Run it beside the mesh: contactsim two_elements.i two_element_contact.g
# {formulation = "face_face"} {friction = 0} {penalty = 1}
# {title = "two elements"} {mesh = "two_element_contact.g"}
# {density = 7800} {bulk = 1.6e11} {shear = 0.8e11}
# {speed = 100} {way_x = 1} {way_y = 0} {way_z = 0} {end_time = 6e-3}
{include("two_bodies.inc")}
