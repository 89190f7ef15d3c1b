# Two flanges of 10 mm are clamped by a bolt of 10 mm and then pulled apart: a quarter of the upper half, the joint is the plane
# z = 0 (mm, N, MPa, t).
#
# Shows preload by OVERLAP RAMP TIME: the bolt's head is meshed 0.01 mm into the flange, and comes out of it over the first
# unit of time, so that the bolt is stretched. Then the flange is pulled at its rim. What a joint is tightened for: while the
# flanges touch, the force in the bolt grows by less than the pull (bolt in bolted_joint.csv), and the force between them falls;
# once they part (joint is 0) the bolt bears it all. All forces are those of the quarter.
#
# pull      what the rim is pulled by at the end [N]
# friction  between head and flange
#
# {ifndef(friction)}
# {friction = 0.15}
# {endif}
# {ifndef(pull)}
# {pull = 3000}
# {endif}
# {rim_area = 0.25 * PI * (25 ** 2 - 18.4 ** 2)}
begin sierra bolted joint
  begin material steel
    density = 7.8e-9
    begin parameters for model elastic
      youngs modulus = 200e3
      poissons ratio = 0.3
    end
  end

  begin definition for function pull
    type = piecewise linear
    begin values
      0 0
      1 0
      3 1
    end
  end

  begin finite element model joint
    database name = bolted_joint.g
    begin parameters for block bolt flange
      material = steel
      model = elastic
    end
  end

  begin adagio procedure tighten
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for adagio region joint
          time increment = 0.25
        end
      end
      termination time = 3
    end

    begin adagio region joint
      use finite element model joint

      begin fixed displacement
        node set = on_x
        component = x
      end
      begin fixed displacement
        node set = on_y
        component = y
      end
      begin fixed displacement
        node set = middle
        component = z
      end
      begin pressure
        surface = pulled
        function = pull
        scale factor = {-pull / rim_area}
      end

      begin analytic object middle_plane
        type = plane
        normal direction = 0 0 1
        origin = 0 0 0
      end

      begin contact definition
        contact surface under_head contains under_head
        contact surface seat contains seat
        contact surface joint contains joint
        contact surface other_half contains middle_plane
        begin constant friction model dry
          friction coefficient = {friction}
        end
        begin interaction tightened
          surfaces = under_head seat
          friction model = dry
          overlap ramp time = 1
        end
        begin interaction flanges
          surfaces = other_half joint
        end
      end

      begin solver
        begin cg
          begin full tangent preconditioner
          end
        end
      end

      begin user output
        surface = under_head
        compute global bolt as sum of nodal force_contact(z)
      end
      begin user output
        surface = joint
        compute global joint as sum of nodal force_contact(z)
      end
      begin heartbeat output
        stream name = %B.csv
        at step 0 increment = 1
        global bolt
        global joint
      end
      begin results output
        database name = %B.e
        at step 0 increment = 1
        nodal variables = displacement force_contact contact_normal_traction_magnitude
        element variables = stress von_mises
      end
    end
  end
end sierra
