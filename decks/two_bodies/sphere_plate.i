# A sphere hits a thin plate at 800 m/s (SI). Mesh: sphere_plate_contact.g of NimbleSM's tests.
# Expected after 0.1 ms: mean displacement of the plate 7.4 mm, of the sphere 73.4 mm (NimbleSM's stored result; 10 %).
#
# Run it beside the mesh: contactsim sphere_plate.i sphere_plate_contact.g
# {formulation = "face_face"} {friction = 0} {penalty = 5}
# {title = "sphere into plate"} {mesh = "sphere_plate_contact.g"}
# {density = 7800} {bulk = 1.6e11} {shear = 0.8e11}
# {speed = 800} {way_x = 1} {way_y = 0} {way_z = 0} {end_time = 1e-4}
{include("two_bodies.inc")}
