# A block slides without friction over the joint of two parts that lie flush beside each other and share no nodes (SI).
#
# Shows that the side faces inside a joint are no obstacle: a slider which penetrates what it slides on a little has a strip
# of its front below the surface of the next part. Expected: 5 m/s along the joint and over it within 0.1 % for solids and
# sheets (shell=1), both formulations, any weight per mass, joints across and askew, open by a hair or by a fifth of an
# element, T joints, one surface of all parts, parts held as a whole (held=1) or on their bottoms alone; and that a step up
# of 3 % of an element does stop the slider, while one down does not.
#
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {ifndef(weight)}
# {weight = 1000}
# {endif}
# {ifndef(shell)}
# {shell = 0}
# {endif}
# {ifndef(held)}
# {held = 1}
# {endif}
# {ifndef(surfaces)}
# {surfaces = "parts"}
# {endif}
# {ifndef(selves)}
# {selves = "off"}
# {endif}
# {frame = 0.003}
begin sierra joint
  begin material rubber
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e8
      poissons ratio = 0.3
    end
  end

{if(shell)}
  begin shell section sheet
    thickness = 0.02
    number of integration points = 3
  end
{endif}

  begin finite element model parts
    database name = joint.g
    begin parameters for block near far
      material = rubber
      model = elastic
{if(shell)}
      section = sheet
{endif}
    end
    begin parameters for block slider
      material = rubber
      model = elastic
    end
  end

  begin presto procedure slide
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region parts
          step interval = 5000
        end
      end
      termination time = 0.06
    end

    begin presto region parts
      use finite element model parts

      begin fixed displacement
{if(held)}
        block = near far
{else}
        node set = bottom
{endif}
        components = x y z
      end
      begin initial velocity
        block = slider
        component = x
        magnitude = 5
      end
      begin gravity
        block = slider
        component = z
        gravitational constant = {-weight}
      end

      begin contact definition
{if(surfaces == "parts")}
        skin all blocks = on
{else}
        contact surface all contains near far slider
{endif}
        begin interaction defaults
          general contact = on
          self contact = {selves}
          constraint formulation = {form}
          contact damping fraction = 0.2
        end
      end

      begin heartbeat output
        stream name = %B.csv
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
