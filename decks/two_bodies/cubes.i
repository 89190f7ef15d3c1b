# Two cubes of soft matter collide face to face, nodes against faces (SI). Mesh: Contact_Cubes.g of Peridigm's tests.
# Expected: equal cubes exchange their velocities.
#
# Run it beside the mesh: contactsim cubes.i Contact_Cubes.g
# {formulation = "node_face"} {friction = 0} {penalty = 1}
# {title = "two cubes"} {mesh = "Contact_Cubes.g"}
# {density = 1000} {bulk = 1e8} {shear = 6e7}
# {speed = -20} {way_x = 1} {way_y = 0} {way_z = 0} {end_time = 7e-2}
{include("two_bodies.inc")}
