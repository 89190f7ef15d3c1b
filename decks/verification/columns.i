# Two columns of 1 m end to end are pressed, or pulled, along their axis in half a second, slowly for waves, and held (SI).
#
# Shows that an interface is no spring: the columns carry what one piece would, as coarse as they may be, under contact and
# ties, and stay apart however far they are pressed. Without Poisson's ratio the force at the driven end is E A times the
# strain. -D rigid=1 makes the upper column a rigid block whose modulus and density must not matter, -D turns=1 lets it turn.
# Expected: force within 2 % of E A strain for 1 to 8 elements each, within 1 % when tied; penetration below 2 % of an element
# at 30 % of strain (12 % with NODE_FACE, where columns may buckle); contact work of the slow ones below 1e-4 of the strain
# energy. ENFORCEMENT = PENALTY presses on a spring that is in no way a rigid block's; it gets stiffer with depth, and the
# columns stay apart.
#
# {ifndef(enforcement)}
# {enforcement = "momentum_balance"}
# {endif}
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {ifndef(law)}
# {law = "frictionless"}
# {endif}
# {ifndef(way)}
# {way = -0.02}
# {endif}
# {ifndef(rigid)}
# {rigid = 0}
# {endif}
# {ifndef(stiffer)}
# {stiffer = 1}
# {endif}
# {ifndef(turns)}
# {turns = 0}
# {endif}
# {ifndef(heavier)}
# {heavier = 1}
# {endif}
# {frame = 0.05}
begin sierra columns
  begin function slowly
    type = analytic
    evaluate expression = "x < 0.5 ? 0.5 * (1 - cos(3.141592653589793 * x / 0.5)) : 1"
  end
  begin material soft
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e7
      poissons ratio = 0
    end
  end
  begin material tool
    density = {1000 * heavier}
    begin parameters for model elastic
      youngs modulus = {1e7 * stiffer}
      poissons ratio = 0
    end
  end
# {if(rigid)}
  begin rigid body upper
  end
  begin solid section of_tool
    rigid body = upper
  end
# {endif}

  begin finite element model columns
    database name = columns.g
    begin parameters for block below
      material = soft
      model = elastic
    end
    begin parameters for block above
      material = tool
      model = elastic
# {if(rigid)}
      section = of_tool
# {endif}
    end
  end

  begin presto procedure press
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region columns
          step interval = 20000
        end
      end
      termination time = 1
    end

    begin presto region columns
      use finite element model columns

      begin fixed displacement
        node set = bottom
        components = z
      end
{if(rigid)}
      begin fixed displacement
        block = above
        components = x y
      end
{if(turns == 0)}
      begin fixed rotation
        block = above
        components = x y z
      end
{endif}
{endif}
      begin prescribed displacement
        {rigid ? "block = above" : "node set = top"}
        component = z
        function = slowly
        scale factor = {way}
      end

      begin contact definition
        skin all blocks = on
        enforcement = {enforcement}
        begin constant friction model rub
          friction coefficient = 0.3
        end
        begin interaction defaults
          general contact = on
          friction model = {law}
          constraint formulation = {form}
        end
      end

      begin heartbeat output
        stream name = %B.csv
        {include("energies.inc")}
        global contact_force_below(z) as force
        global contact_penetration_max as penetration
      end
      {include("results.inc")}
    end
  end
end sierra
