# Axial crush of a thin-walled crash box with a bumper beam.
#
# What it models
#   A square tube of high-strength steel, 80 mm wide and 300 mm long, made of two C-shaped halves whose flanges are joined
#   by rows of spot welds. The wall grows in gauge from front to rear over six rings; four triggers (dents in the mesh)
#   make the first fold start at the front. Before the tube stands a bumper beam with a foam absorber, bolted (tied) to
#   the tube's front plate. A rigid striker of half a tonne hits the beam at 15 km/h and is stopped by folding. The tube
#   stands on a rigid wall. Asked for: force over stroke, mean crush force, energy per mass, welds that open, the folds'
#   contact with themselves.
#
# Units
#   SI: metre, kilogram, second: force in N, stress in Pa, energy in J, density in kg/m^3.
#
# Mesh: crush_tube.g, tube axis along x, the wall at x = 0, the striker comes from +x. Parts expected:
#   blocks (shells)   ring_1..ring_6 (tube wall, front is 6), flange_left flange_right, front_plate rear_plate, beam
#   blocks (solids)   absorber (foam), striker, wall
#   blocks (others)   cables (trusses of the wiring behind the beam)
#   side sets         weld_face_1..weld_face_4 (flange faces that the weld rows hold on to), plate_front plate_back,
#                     beam_back, absorber_back, striker_front, wall_front, tube_foot
#   node sets         weld_row_1..weld_row_4 (nodes of the other flange), tube_foot_nodes, triggers, symmetry_y
#   assemblies        tube (ring_1..6, flanges), front (beam, absorber, front_plate)
#
# How to run, in this folder
#   contactsim crush_tube.i --parse                              reads the deck, no mesh needed
#   contactsim crush_tube.i --check                              resolves the contact surfaces
#   contactsim crush_tube.i -D grade=3 -D speed_kmh=40           softer steel, faster
#   contactsim crush_tube.i -D drive=stroke                      pushed at constant speed, for the crush force alone
#   contactsim crush_tube.i -D half=1                            half model, cut at y = 0
#
# {include("study.inc")}

begin sierra crash box

  title Crash box, steel grade {grade}, {drive} at {speed_kmh} km/h

  define direction forward with vector -1.0 0.0 0.0
  define direction sideways with vector 0.0 1.0 0.0
  define direction upright with vector 0.0 0.0 1.0
  define point foot with coordinates 0.0 0.0 0.0
  define point front with coordinates {tube_length} 0.0 0.0
  define point beside with coordinates 0.0 {tube_width} 0.0
  define axis tube_axis with point foot direction forward
  define coordinate system along_tube rectangular with point foot point front point beside

  # {include("steel.inc")}
  # {include("curves.inc")}

  # ---- foam, cables, rigid parts -----------------------------------------------------------------------------------

  # Expanded polypropylene, 40 kg/m^3: springs back, hardly widens.
  begin material absorber_foam
    density = 40.0
    begin parameters for model neo_hookean
      youngs modulus = 3.0e6
      poissons ratio = 0.05
    end parameters for model neo_hookean
    begin parameters for model hyperfoam
      n = 2
      shear = 1.1e6 0.2e6
      alpha = 8.0 -2.0
      poisson = 0.02 0.02
    end parameters for model hyperfoam
  end material absorber_foam

  begin material copper
    density = 8900.0
    begin parameters for model elastic
      youngs modulus = 115.0e9
      poissons ratio = 0.34
    end parameters for model elastic
  end material copper

  begin material tool_steel
    density = 7850.0
    begin parameters for model elastic
      youngs modulus = 210.0e9
      poissons ratio = 0.30
    end parameters for model elastic
  end material tool_steel

  begin rigid body sled
    mass = {striker_mass}
    inertia = 12.0 9.0 9.0 0.0 0.0 0.0
    reference location = {striker_face + 0.15}, 0.0, 0.0
  end rigid body sled

  begin rigid body ground
    include nodes in tube_foot_nodes
  end rigid body ground

  # ---- sections ----------------------------------------------------------------------------------------------------

  # {loop(n_rings, k, 1)}
  begin shell section gauge_{k}
    # {gauge = front_gauge + (n_rings - k) * gauge_step} m: thicker towards the rear.
    thickness = {gauge}
    formulation = bt_shell
    number of integration points = {n_points}
    orientation = along_tube
    drilling stiffness factor = 1.0e-5
  end shell section gauge_{k}
  # {endloop}

  begin shell section flange
    thickness = {2 * front_gauge}
    thickness scale factor = 0.5
    formulation = bt_shell
    number of integration points = {n_points}
    lofting factor = 0.5
  end shell section flange

  begin shell section plate
    thickness = 6.0e-3
    number of integration points = 3
  end shell section plate

  begin shell section beam
    thickness = 2.0e-3
    formulation = bl_shell
    integration rule = gauss
    number of integration points = {n_points}
  end shell section beam

  begin truss section cable
    area = 10.0e-6
  end truss section cable

  begin solid section foam
    formulation = mean_quadrature
    strain incrementation = strongly_objective
    hourglass formulation = total
  end solid section foam

  begin solid section moving
    rigid body = sled
  end solid section moving

  begin solid section standing
    rigid body = ground
  end solid section standing

  # ---- mesh --------------------------------------------------------------------------------------------------------

  begin finite element model crash_box
    database name = %B.g
    database type = exodusII

    # {loop(n_rings, k, 1)}
    begin parameters for block ring_{k}
      material = wall_steel
      model = {wall_model}
      section = gauge_{k}
      linear bulk viscosity = 0.06
      quadratic bulk viscosity = 1.2
      hourglass stiffness = 0.03
    end parameters for block ring_{k}
    # {endloop}

    begin parameters for block flange_left flange_right
      material = wall_steel
      model = {wall_model}
      section = flange
    end parameters for block flange_left flange_right

    begin parameters for block front_plate rear_plate
      material = plate_steel
      model = elastic_plastic
      section = plate
    end parameters for block front_plate rear_plate

    begin parameters for block beam
      material = beam_steel
      model = ep_power_hard
      section = beam
    end parameters for block beam

    begin parameters for block absorber
      material = absorber_foam
      model = neo_hookean
      section = foam
      hourglass stiffness = 0.05
      hourglass viscosity = 0.02
      effective moduli model = current
    end parameters for block absorber

    begin parameters for block striker
      material = tool_steel
      model = elastic
      section = moving
    end parameters for block striker

    begin parameters for block wall
      material = tool_steel
      model = elastic
      section = standing
    end parameters for block wall

    begin parameters for block cables
      material = copper
      model = elastic
      section = cable
    end parameters for block cables
  end finite element model crash_box

  begin output scheduler film
    at time 0.0 increment = {termination / film_frames}
    additional times = {buckling} {2 * buckling}
  end output scheduler film

  begin solid mechanics procedure crash

    begin time control
      begin time stepping block first_contact
        start time = 0.0
        begin parameters for presto region box
          time step scale factor = 0.9
          time step increase factor = 1.05
          step interval = 1000
        end parameters for presto region box
      end time stepping block first_contact
      begin time stepping block folding
        start time = {buckling}
        begin parameters for presto region box
          time step scale factor = 0.8
          step interval = 1000
        end parameters for presto region box
      end time stepping block folding
      begin time stepping block springback
        start time = {stop_time}
        begin parameters for presto region box
          time step scale factor = 0.9
          step interval = 1000
        end parameters for presto region box
      end time stepping block springback
      termination time = {termination}
    end time control

    begin solid mechanics region box
      use finite element model crash_box

      # ---- what holds and what moves -------------------------------------------------------------------------------

      begin fixed displacement wall_stands
        rigid body = ground
        components = x y z
      end fixed displacement wall_stands

      begin fixed rotation wall_does_not_turn
        rigid body = ground
        components = x y z
      end fixed rotation wall_does_not_turn

      # The sled runs on rails.
      begin fixed displacement rails
        rigid body = sled
        components = y z
      end fixed displacement rails

      begin fixed rotation rails
        rigid body = sled
        components = x y z
      end fixed rotation rails

{switch(drive)}
{case("impact")}
      begin initial velocity sled_speed
        rigid body = sled
        direction = forward
        magnitude = {speed}
      end initial velocity sled_speed
{case("stroke")}
      begin prescribed velocity sled_pushes
        rigid body = sled
        direction = forward
        function = push
        scale factor = {speed}
        active periods = first_contact folding
      end prescribed velocity sled_pushes
{endswitch}

{if(half == 1)}
      begin fixed displacement cut
        node set = symmetry_y
        component = y
      end fixed displacement cut

      begin fixed rotation cut
        node set = symmetry_y
        components = x z
      end fixed rotation cut
{endif}

      # A small push at the triggers, so that the first fold goes the same way in every run.
      begin prescribed force trigger_push
        node set = triggers
        direction = sideways
        function = trigger_push
        scale factor = {trigger_force}
        active periods = first_contact
      end prescribed force trigger_push

      begin gravity
        include all blocks
        component = z
        gravitational constant = -9.81
      end gravity

      # ---- contact -------------------------------------------------------------------------------------------------

      begin contact definition folds
        # Joints first: they keep their faces.
        contact surface joint_front contains plate_front
        contact surface joint_beam contains beam_back
        contact surface joint_absorber contains absorber_back
        contact surface face_striker contains striker_front
        contact surface face_wall contains wall_front
        contact surface plate_inside contains plate_back

        # {loop(n_weld_rows, k, 1)}
        contact surface held_{k} contains weld_face_{k}
        # {endloop}

        # The tube ring by ring, so that the log tells where the folds touch.
        # {loop(n_rings, k, 1)}
        begin contact surface ring_{k}
          block = ring_{k}
        end contact surface ring_{k}
        # {endloop}

        begin contact surface flanges
          block = flange_left flange_right
          remove surface = weld_face_1 weld_face_2 weld_face_3 weld_face_4
        end contact surface flanges

        # The front parts, split into what faces the striker and the rest.
        begin contact surface bumper
          assembly = front
          remove surface = beam_back absorber_back plate_front plate_back
          subset ahead with normal 1 0 0
        end contact surface bumper

        begin contact surface rear
          block = rear_plate
        end contact surface rear

        begin contact surface rigid_parts
          block = striker wall
          remove surface = striker_front wall_front
        end contact surface rigid_parts

        contact surface wiring contains cables
        contact node set foot contains tube_foot

        restrict contact to subdomain defined by radius {reach} and point {0.5 * tube_length} 0.0 0.0

        begin constant friction model steel_on_steel
          friction coefficient = {friction}
        end constant friction model steel_on_steel

        # Paint rubs off within a few metres per second.
        begin pv_dependent model painted
          static coefficient = 0.25
          dynamic coefficient = {friction}
          velocity decay = 0.5
          reference pressure = 50.0e6
          offset pressure = 1.0e6
          pressure exponent = 0.0
        end pv_dependent model painted

        begin constant friction model foam_on_steel
          friction coefficient = 0.5
        end constant friction model foam_on_steel

        begin tied model bolted
        end tied model bolted

        # The absorber is clipped on: it leaves when it is pulled with 0.3 N/mm^2.
        begin adhesion model clipped
          adhesion function = clip_pull
        end adhesion model clipped

        # The flange adhesive between the weld points.
        begin junction model flange_adhesive
          normal traction function = adhesive_normal
          tangential traction function = adhesive_shear
          normal cutoff distance for tangential traction = 0.5e-3
        end junction model flange_adhesive

        begin surface weld model foot_seam
          normal capacity = 42.0e3
          tangential capacity = 36.0e3
          failure decay cycles = 25
          failed model = steel_on_steel
        end surface weld model foot_seam

        begin spring weld model clip
          normal displacement function = clip_force
          normal displacement scale factor = 1.0
          tangential displacement function = clip_force
          tangential displacement scale factor = 0.6
          failure envelope exponent = 1.5
          failed model = frictionless
        end spring weld model clip

        begin time variant model striker_face
          model = painted during periods first_contact
          model = steel_on_steel during periods folding springback
        end time variant model striker_face

        begin interaction defaults everything
          general contact = on
          self contact = on
          friction model = steel_on_steel
          constraint formulation = face_face
          interaction behavior = sliding
        end interaction defaults everything

        begin interaction beam_on_plate
          surfaces = joint_front joint_beam
          friction model = bolted
          normal tolerance = 1.0e-3
          tangential tolerance = 1.0e-3
        end interaction beam_on_plate

        begin interaction absorber_on_beam
          side a = bumper
          side b = joint_absorber
          friction model = clipped
          constraint formulation = node_face
          capture tolerance = 0.5e-3
        end interaction absorber_on_beam

        begin interaction striker_on_front
          side a = face_striker
          side b = bumper bumper_ahead
          friction model = striker_face
        end interaction striker_on_front

        begin interaction foam_squeezed
          surfaces = bumper bumper_ahead
          friction model = foam_on_steel
          overlap normal tolerance = 1.0e-3
          overlap tangential tolerance = 1.0e-3
        end interaction foam_squeezed

        begin interaction foot_on_wall
          side a = face_wall
          side b = foot
          friction model = foot_seam
          constraint formulation = node_face
        end interaction foot_on_wall

        begin interaction tube_on_rear
          surfaces = ring_1 rear
          friction model = tied
          normal tolerance = 2.0e-3
        end interaction tube_on_rear

        # {loop(n_weld_rows, k, 1)}
        begin interaction flange_{k}
          surfaces = held_{k} flanges
          friction model = flange_adhesive
        end interaction flange_{k}
        # {endloop}

        # Rings that follow one another share nodes; the folds between them meet all the same.
        # {loop(n_rings, k, 1)}
        begin interaction fold_in_{k}
          surfaces = ring_{k} ring_{k}
          friction model = painted
        end interaction fold_in_{k}
        # {endloop}

        begin interaction cable_clips
          side a = plate_inside
          side b = wiring
          friction model = clip
        end interaction cable_clips

        # Rigid parts never meet one another.
        begin interaction rigid
          surfaces = rigid_parts face_striker face_wall
          interaction behavior = no_interaction
        end interaction rigid

        search = dash
        begin search options tight
          search tolerance = user_defined
          normal tolerance = {3 * front_gauge}
          tangential tolerance = {3 * front_gauge}
        end search options tight
        begin dash options
          search length scaling = 0.15
        end dash options
        begin enforcement options
          penalty scale = 1
        end enforcement options
        begin surface options walls
          surface = ring_1 ring_2 ring_3 ring_4 ring_5 ring_6 flanges
          contact shell thickness = actual_thickness
          coincident shell treatment = disallow
        end surface options walls
        begin surface options wiring
          surface = wiring
          beam radius = 1.8e-3
        end surface options wiring

        initial overlap removal = on
        begin remove initial overlap
          overlap normal tolerance = {0.5 * front_gauge}
          overlap iterations = 50
          shell overlap iterations = 50
          shell overlap tolerance = 0.0
        end remove initial overlap

        begin debug
          visualize contact facets = off
          output level = 0
        end debug
      end contact definition folds

      # ---- spot welds ----------------------------------------------------------------------------------------------

      # {loop(n_weld_rows, k, 1)}
      begin spot weld row_{k}
        node set = weld_row_{k}
        surface = weld_face_{k}
        normal displacement function = weld_pull
        normal displacement scale factor = {weld_strength}
        tangential displacement function = weld_shear
        tangential displacement scale factor = {weld_strength}
        failure envelope exponent = 2.0
        failure decay cycles = 50
        ignore initial offsets = on
      end spot weld row_{k}
      # {endloop}

      # ---- element death, end of the run ---------------------------------------------------------------------------

      begin element death wall_tears
        assembly = tube
        criterion is element value of eqps > {fracture_strain} kill when 1 integration points remain
        check step interval = 10
        death steps = 10
        death start time = {buckling}
      end element death wall_tears

      begin element death foam_gone
        include blocks with material = absorber_foam
        criterion is max nodal value of coordinates(x) < 0.0
        death on inversion = on
      end element death foam_gone

      begin solution termination stopped
        terminate global velx_sled > {0.1 * speed}
        terminate global timestep < 1.0e-9
        skip times = 0.0 to {buckling}
        terminate type = entire_run
      end solution termination stopped

      begin mass properties weighed
        assembly = tube front
        structure name = "crash box"
      end mass properties weighed

      # {include("results.inc")}

    end solid mechanics region box
  end solid mechanics procedure crash
end sierra crash box
