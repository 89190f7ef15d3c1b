# Half of a slab of rubber, 7 x 4 x 2 mm, into which a segment of a cylinder of 3 mm of radius, wider than the slab and ten times as
# stiff, is pressed by 0.3 mm and then drawn along it by 2 mm with friction of 0.3 (mm, N, MPa, t; shear moduli of 1 and 10 MPa): shallow
# ironing, after Fischer and Wriggers, Comput. Methods Appl. Mech. Eng. 195 (2006) 5020-5036, in three dimensions.
#
# Shows contact of load steps that moves on over many faces with friction, under large strains. No number is published for it: finer meshes
# and smaller steps give the same forces, within 3 %, and the forces change by no more than 3 % as the segment goes on from face to face. A
# segment narrower than the slab, whose sharp edge runs along a line of nodes, does as well.
#
# way  that the segment is drawn by
#
# {ifndef(steps)}
# {steps = 10}
# {endif}
# {ifndef(way)}
# {way = 2}
# {endif}
# {frame = 1}
begin sierra static ironing
  begin material soft
    density = 1e-9
    begin parameters for model neo_hookean
      shear modulus = 1
      bulk modulus = 5
    end
  end
  begin material hard
    density = 1e-9
    begin parameters for model neo_hookean
      shear modulus = 10
      bulk modulus = 50
    end
  end

  begin definition for function down
    type = piecewise linear
    begin values
      0  0
      1 -0.3
      2 -0.3
    end
  end
  begin definition for function along
    type = piecewise linear
    begin values
      0 0
      1 0
      2 {way}
    end
  end

  begin finite element model bodies
    database name = static_ironing.g
    begin parameters for block slab
      material = soft
      model = neo_hookean
    end
    begin parameters for block die
      material = hard
      model = neo_hookean
    end
  end

  begin adagio procedure iron
    begin time control
      begin time stepping block press
        start time = 0
        begin parameters for adagio region bodies
          number of time steps = {steps / 2}
        end
      end
      begin time stepping block slide
        start time = 1
        begin parameters for adagio region bodies
          number of time steps = {2 * steps}
        end
      end
      termination time = 2
    end

    begin adagio region bodies
      use finite element model bodies

      begin fixed displacement
        node set = bottom
        components = x y z
      end
      begin fixed displacement
        node set = middle
        component = y
      end
      begin fixed displacement
        node set = top
        component = y
      end
      begin prescribed displacement
        node set = top
        component = z
        function = down
      end
      begin prescribed displacement
        node set = top
        component = x
        function = along
      end

      begin contact definition
        skin all blocks = on
        begin constant friction model rubbing
          friction coefficient = 0.3
        end
        begin interaction defaults
          general contact = on
          friction model = rubbing
        end
      end

      begin solver
        begin cg
          begin full tangent preconditioner
          end
        end
      end

      begin user output
        node set = bottom
        compute global pressed as sum of nodal reaction(z)
        compute global drawn as sum of nodal reaction(x)
      end
      begin heartbeat output
        stream name = %B.csv
        global pressed
        global drawn
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
