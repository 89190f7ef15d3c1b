# A strip of rubbery membranes or shells, 1 m long, 0.2 m wide and 0.01 m thick, is pulled slowly to 1.5 times its length.
#
# Shows that the thickness follows the strain. The law is hypoelastic, so that the stress is E ln(l), with the stretch l along
# the strip and l^-nu across it and through the thickness; the work is E V times the integral of e exp((1 - 2 nu) e) over the
# strain e. Expected within 0.2 %. -D section="membrane" or "shell".
#
# {ifndef(section)}
# {section = "membrane"}
# {endif}
begin sierra pulled strip
  begin material rubber
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e6
      poissons ratio = 0.3
    end
  end

  begin {section} section strip
    thickness = 0.01
  end

  begin definition for function pull
    type = analytic
    evaluate expression = "0.25 * (1 - cos(3.141592653589793 * min(x, 1)))"
  end

  begin finite element model strip
    database name = pulled_strip.g
    begin parameters for block strip
      material = rubber
      model = elastic
      section = strip
    end
  end

  begin presto procedure pull
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region strip
          step interval = 1000
        end
      end
      termination time = 1.05
    end

    begin presto region strip
      use finite element model strip

      begin fixed displacement
        node set = held
        components = x z
      end
      begin fixed displacement
        node set = axis
        components = y
      end
      begin fixed displacement
        block = strip
        components = z
      end
      begin prescribed displacement
        node set = pulled
        component = x
        function = pull
      end

      begin heartbeat output
        stream name = %B.csv
        precision = 12
        at step 0 increment = 10
        element memb_stress(xx) nearest location 0.5 0.05 0 as stress
        element element_thickness nearest location 0.5 0.05 0 as thickness
        nodal displacement(y) nearest location 0.5 0.1 0 as side
        global energy_error as energy_error
        global external_energy as external_energy
      end
    end
  end
end sierra
