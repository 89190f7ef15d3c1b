# Drop of a crash-protected flight recorder onto a hard floor.
#
# What it models
#   An aluminium case of two halves, sealed by a silicone gasket and closed by eight steel bolts with preload. Inside: a
#   circuit board (shells) with ceramic memory chips soldered on, a battery treated as rigid, a steel bracket spot-welded
#   to a sheet-steel cover. Outside: a foam pad bonded to each corner. The recorder falls 1.2 m flat, on an edge or on a
#   corner, onto an ideal plane or onto a meshed anvil. Asked for: do the chips stay on, does the case stay closed, how
#   hard is the battery shaken, do the pads come off.
#
# Units
#   mm, tonne, s: force in N, stress in MPa, energy in mJ, density in tonne/mm^3, gravity 9810 mm/s^2.
#
# Mesh: drop_test.g. The mesh stands upright (z up, the case's lower face at z = 0, its centre on the z axis); the way
# of falling turns the floor, not the mesh. Parts expected:
#   blocks (solids)   base lid gasket bolt_1..bolt_8 chips battery foam_1..foam_8, and anvil when ground is "anvil"
#   blocks (others)   cover bracket board (shells), tendon (trusses in the bolts), pins (beams), gauge (a point mass)
#   side sets         base_thread_1..8 bolt_thread_1..8 bolt_seat_1..8 pad_bond_1..8 case_bond_1..8 board_back
#                     chip_feet gasket_sides cover_welds battery_foot case_inside
#   node sets         bracket_welds board_rim case_corners
#   assemblies        housing (base, lid, gasket), bolts (bolt_1..8), pads (foam_1..8), electronics (board, chips)
#
# How to run, in this folder
#   contactsim drop_test.i --parse                                  reads the deck, no mesh needed
#   contactsim drop_test.i --check                                  resolves the contact surfaces
#   contactsim drop_test.i -D way=corner -D drop_height=1800        the worst fall
#   contactsim drop_test.i -D ground=anvil -D foam_model=orthotropic_crush
#
# What may be set with -D: see parameters.inc.

{include("parameters.inc")}

begin sierra flight recorder drop

  title Drop of a flight recorder from {drop_height} mm, way: {way}, ground: {ground}

  # ---- directions, axes, coordinate systems ------------------------------------------------------------------------

  # The floor turns instead of the mesh. Its normal points to the recorder, the fall goes against it.
{if(way == "flat")}
  define direction fall with vector 0.0 0.0 -1.0
{elseif(way == "edge")}
  define direction fall with vector {-sind(tilt)} 0.0 {-cosd(tilt)}
{elseif(way == "corner")}
  define direction fall with vector -1.0 -1.0 -1.0
{endif}

  define direction up with vector 0.0 0.0 1.0
  define point centre with coordinates 0.0, 0.0, {0.5 * case_height}
  define point centre_top with coordinates 0.0 0.0 {case_height}
  define point centre_side with coordinates {0.5 * case_length} 0.0 {0.5 * case_height}
  define axis tumble with point centre point centre_side
  define coordinate system board_directions rectangular with point centre point centre_top point centre_side

  {include("functions.inc")}
  {include("materials.inc")}
  {include("sections.inc")}

  # ---- rigid bodies ------------------------------------------------------------------------------------------------

  # The cells inside are not of interest, their mass is.
  begin rigid body battery_body
    reference location = 0.0, 0.0, {0.35 * case_height}
    mass = {battery_mass}
    inertia = {battery_mass / 12 * (40^2 + 20^2)} {battery_mass / 12 * (60^2 + 20^2)} \#
              {battery_mass / 12 * (60^2 + 40^2)} 0.0 0.0 0.0
  end rigid body battery_body

{if(ground == "anvil")}
  begin rigid body anvil_body
  end
{endif}

  # ---- mesh and its parts ------------------------------------------------------------------------------------------

  begin finite element model recorder
    database name = %B.g
    database type = exodusII
    alias cover as lid_cover

    begin parameters for block base lid
      material = aluminium
      model = johnson_cook
      section = metal_solid
      hourglass stiffness = 0.05
      linear bulk viscosity = 0.06
      quadratic bulk viscosity = 1.2
    end

    begin parameters for block gasket
      material = silicone
      model = neo_hookean
      section = rubber_solid
    end

    # {loop(n_bolts, k, 1)}
    begin parameters for block bolt_{k}
      material = bolt_steel
      model = elastic_plastic
      section = metal_solid
    end
    # {endloop}

    # The preload sits in trusses along the bolts' axes, which share the nodes of head and thread.
    begin parameters for block tendon
      material = bolt_steel
      model = elastic
      section = preload
    end

    begin parameters for block cover bracket
      material = sheet_steel
      model = ep_power_hard
      section = sheet
    end

    begin parameters for block board
      material = laminate
      model = elastic
      section = circuit_board
    end

    begin parameters for block chips
      material = ceramic
      model = elastic
      section = metal_solid
    end

    begin parameters for block battery
      material = cells
      solid mechanics use model elastic
      section = battery_rigid
    end

    # {loop(n_pads, k, 1)}
    begin parameters for block foam_{k}
      material = foam
      model = {foam_model}
      section = foam_solid
      effective moduli model = presto
      hourglass stiffness = 0.02
      hourglass viscosity = 0.01
    end
    # {endloop}

    begin parameters for block pins
      material = sheet_steel
      model = elastic
      section = connector_pin
    end

    begin parameters for block gauge
      material = cells
      model = elastic
      section = accelerometer
    end

{if(ground == "anvil")}
    begin parameters for block anvil
      material = bolt_steel
      model = elastic
      section = anvil_rigid
    end
{endif}
  end finite element model recorder

  # ---- when output is written --------------------------------------------------------------------------------------

  begin output scheduler fine_after_impact
    at time 0.0 increment = {termination / 20}
    at time {first_touch} increment = {termination / 200}
    timestep adjustment interval = 4
  end

  begin presto procedure drop

    begin time control
      # The recorder starts just above the floor, at its full speed.
      begin time stepping block approach
        start time = 0.0
        begin parameters for presto region recorder
          initial time step = 1.0e-8
          time step scale factor = 0.9
          time step increase factor = 1.1
          step interval = 500
        end
      end
      begin time stepping block impact
        start time = {first_touch}
        begin parameters for presto region recorder
          time step scale factor = 0.8
          step interval = 200
        end
      end
      begin time stepping block rebound
        start time = {first_touch + 0.6 * (termination - first_touch)}
        begin parameters for presto region recorder
          time step scale factor = 0.9
          step interval = 500
        end
      end
      termination time = {termination}
    end time control

    begin presto region recorder

      use finite element model recorder

      # ---- initial and boundary conditions -------------------------------------------------------------------------

      begin initial velocity falling
        include all blocks
{if(ground == "anvil")}
        remove block = anvil
{endif}
        direction = fall
        magnitude = {impact_speed}
      end

{if(tumble_rate != 0)}
      begin initial velocity tumbling
        assembly = housing bolts pads electronics
        block = cover bracket battery pins
        cylindrical axis = tumble
        angular velocity = {tumble_rate}
      end
{endif}

      begin gravity
        include all blocks
        direction = fall
        gravitational constant = {gravity}
      end

{if(ground == "anvil")}
      begin fixed displacement anvil_stands
        rigid body = anvil_body
        components = x y z
      end
      begin fixed rotation anvil_does_not_turn
        rigid body = anvil_body
        components = x/y/z
      end
{else}
      # The floor touches the recorder's lowest point, {stand_off} mm below it.
      begin analytic object concrete
        type = plane
  {if(way == "flat")}
        normal direction = 0.0 0.0 1.0
        origin = 0.0 0.0 {-pad_thickness - stand_off}
  {elseif(way == "edge")}
        normal direction = {sind(tilt)} 0.0 {cosd(tilt)}
        origin = {-0.5 * case_length - pad_thickness - stand_off * sind(tilt)} 0.0 \#
                 {-pad_thickness - stand_off * cosd(tilt)}
  {else}
        normal direction = 1.0 1.0 1.0
        origin = {-0.5 * case_length - pad_thickness - stand_off / sqrt(3)} \#
                 {-0.5 * case_width - pad_thickness - stand_off / sqrt(3)} {-pad_thickness - stand_off / sqrt(3)}
  {endif}
        scale factor = 0.5
      end
{endif}

      # Pressure in the sealed case while the seal holds: 0.02 MPa over the air around it.
      begin pressure sealed_air
        surface = case_inside
        function = seal_pressure
        scale factor = 0.02
        inactive periods = rebound
      end

      # ---- contact -------------------------------------------------------------------------------------------------
      # Order decides: the side sets that are tied or threaded come first and keep their faces, then the parts that are
      # named, and SKIN ALL BLOCKS takes what is left.

      begin contact definition crash

        # Bolts: threads held, heads pressed on their seats.
        # {loop(n_bolts, k, 1)}
        contact surface thread_{k} contains bolt_thread_{k}
        contact surface hole_{k} contains base_thread_{k}
        contact surface seat_{k} contains bolt_seat_{k}
        # {endloop}

        # Pads: glued to the case on one side.
        # {loop(n_pads, k, 1)}
        contact surface pad_glue_{k} contains pad_bond_{k}
        contact surface case_glue_{k} contains case_bond_{k}
        # {endloop}

        contact surface solder_side contains chip_feet
        contact surface board_side contains board_back
        contact surface battery_side contains battery_foot

        # The case outside, parted by where it faces: what lies towards the floor is treated apart.
        begin contact surface case
          assembly = housing
          remove surface = gasket_sides
          # {loop(n_bolts, k, 1)}
          remove surface = base_thread_{k}
          # {endloop}
          # {loop(n_pads, k, 1)}
          remove surface = case_bond_{k}
          # {endloop}
          subset below with normal 0 0 -1
          subset left with normal -1 0 0
          subset right with normal 1 0 0
        end contact surface case

        # Cover and bracket with their edges; the welded rim is not to meet itself.
        begin contact surface sheets
          block = cover bracket
          remove surface = cover_welds
        end

        begin contact surface seal
          surface = gasket_sides
        end

        # {loop(n_pads, k, 1)}
        begin contact surface pad_{k}
          block = foam_{k}
          remove surface = pad_bond_{k}
        end
        # {endloop}

{if(ground == "plane")}
        contact surface floor contains concrete
{else}
        contact surface floor contains anvil
{endif}

        contact node set rim contains board_rim
        contact node set corners contains case_corners

        # What has no surface yet, each block by its name: board, pins, and the bolts, chips and battery less the faces
        # that are joined above. The trusses and the point mass touch nothing.
{if(ground == "anvil")}
        skin all blocks = on exclude housing pads cover bracket tendon gauge anvil
{else}
        skin all blocks = on exclude housing pads cover bracket tendon gauge
{endif}

        # Nothing farther away than this can be reached: the anvil is large.
        restrict contact to subdomain defined by radius {reach} and point 0.0, 0.0, {0.5 * case_height}

        {include("friction.inc")}

        begin interaction defaults
          general contact = on
          self contact = off
          friction model = metal_on_metal
          constraint formulation = face_face
        end interaction defaults

        # {loop(n_bolts, k, 1)}
        begin interaction bolt_{k}_thread
          side a = hole_{k}
          side b = thread_{k}
          friction model = thread
          constraint formulation = node_face
          normal tolerance = 0.1
          tangential tolerance = 0.1
        end
        begin interaction bolt_{k}_head
          surfaces = seat_{k} case
          friction model = under_head
          capture tolerance = 0.02
        end
        # {endloop}

        # {loop(n_pads, k, 1)}
        begin interaction pad_{k}_bond
          surfaces = pad_glue_{k} case_glue_{k}
          friction model = pad_bond
          normal tolerance = 0.2
        end
        begin interaction pad_{k}_on_floor
          surfaces = pad_{k} floor
          friction model = foam_on_floor
        end
        # Pads fold on themselves when they are crushed.
        begin interaction pad_{k}_self
          surfaces = pad_{k}
          friction coefficient = 0.5
        end
        # {endloop}

        begin interaction case_hits_floor
          side a = floor
          side b = case case_below case_left case_right
          friction model = metal_on_floor
        end

        # The parts of one case do not meet one another.
        begin interaction one_case
          surfaces = case case_below case_left case_right
          interaction behavior = no_interaction
        end

        begin interaction solder
          side a = board_side
          side b = solder_side
          friction model = solder_joint
        end

        begin interaction tape
          surfaces = battery_side case
          friction model = double_sided_tape
        end

        begin interaction sealing
          surfaces = seal case
          friction model = seal_by_gap
          overlap normal tolerance = 0.3
        end

        begin interaction board_in_groove
          side a = case
          side b = rim
          friction model = groove
        end

        begin interaction corners_on_floor
          master = floor
          slave = corners
          friction model = metal_on_floor
          active periods = impact rebound
        end

        begin interaction sheets_fold
          surfaces = sheets sheets
          friction model = metal_on_metal
        end

        search = dash
        begin search options
          search tolerance = automatic
        end
        begin enforcement options
          penalty scale = 1
        end
        begin surface options
          surface = sheets
          contact shell thickness = let_contact_choose
          allowable shell thickness = 0.1 to 0.8
          coincident shell treatment = simple
        end
        begin surface options
          surface = pins
          beam radius = 0.3
        end

        initial overlap removal = on
        begin remove initial overlap
          overlap normal tolerance = 0.05
          overlap tangential tolerance = 0.05
          overlap iterations = 20
          shell overlap iterations = 20
        end

        compute contact variables = every_step
      end contact definition crash

      # ---- welds ---------------------------------------------------------------------------------------------------

      begin spot weld bracket_to_cover
        node set = bracket_welds
        surface = cover_welds
        normal displacement function = weld_pull
        tangential displacement function = weld_shear
        failure envelope exponent = 2.0
        failure decay cycles = 20
      end

      # ---- what breaks ---------------------------------------------------------------------------------------------

      begin element death chips_crack
        block = chips
        criterion is element value of max_principal_stress > {ceramic_strength}
        check step interval = 5
        death steps = 5
      end

      begin element death pads_tear
        assembly = pads
        criterion is element value of max_principal_log_strain > 1.1
        criterion is element value of element_shape < 0.01
        death on inversion = on
        death start time = {first_touch}
      end

      begin element death case_cracks
        block = base lid
        criterion is element value of eqps > 0.12
        death steps = 10
      end

{if(target_step > 0)}
      # Adds mass where the chips' small elements would hold everything up.
      begin mass scaling fine_parts
        block = chips pins
        target time step = {target_step}
        allowable mass increase ratio = 1.05
      end
{endif}

      begin mass properties
        assembly = housing bolts
        structure name = "closed case"
      end

      {include("output.inc")}

    end presto region recorder

  end presto procedure drop

end sierra
