# A cantilever that sags under its weight in load steps, goes on at rest by explicit dynamics, and swings once the weight is gone
# (SI): three procedures, each from the state of the one before.
#
# Shows PROCEDURAL TRANSFER: no ringing, kinetic energy below 1e-8 of the strain energy in the 100 steps after the static preload
# (and in all others until the release). Then the beam of solid elements, 1 x 0.05 x 0.05 m of steel, vibrates about its straight
# shape, 40.9 Hz by Euler and Bernoulli (see cantilever.i) within 3 %, and the sum of all energies stays: strain energy of the
# preload becomes kinetic energy.
# With -D section=shell: a quarter of a circle of shells, radius 1 m, thickness 0.02 m, clamped at its foot. Its drilling
# stiffness goes over from the load steps: moments about the normals of flat shells are part of their equilibrium.
# With -D section=plastic the beam's root yields: solids of elastic-plastic material under 150 times its weight.
#
# {ifndef(section)}
# {section = "solid"}
# {endif}
# {model = section == "plastic" ? "elastic_plastic" : "elastic"}
# {weight = 9.81 * (section == "plastic" ? 150 : 1)}
begin sierra preload
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.0
    end
    begin parameters for model elastic_plastic
      youngs modulus = 200e9
      poissons ratio = 0.0
      yield stress = 400e6
      hardening modulus = 10e9
    end
  end

{if(section == "shell")}
  begin shell section beam
    thickness = 0.02
  end
{else}
  begin solid section beam
  end
{endif}

  begin definition for function weight
    type = piecewise linear
    begin values
      0 0
      1 1
    end
  end

  begin finite element model beam
    database name = preload.g
    begin parameters for block beam
      material = steel
      model = {model}
      section = beam
    end
  end

  begin adagio procedure sag
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for adagio region load
          number of time steps = 4
        end
      end
      termination time = 1
    end

    begin adagio region load
      use finite element model beam

      begin fixed displacement
        node set = clamped
        components = x y z
      end
{if(section == "shell")}
      begin fixed rotation
        node set = clamped
        components = x y z
      end
{endif}
      begin gravity
        include all blocks
        component = z
        gravitational constant = {weight}
        function = weight
        scale factor = -1
      end

      begin solver
        begin cg
          target relative residual = 1e-8
          begin full tangent preconditioner
          end
        end
      end

      begin heartbeat output
        stream name = %B.csv
        precision = 12
        at step 0 increment = 1
        nodal displacement(z) nearest location {section == "shell" ? 0 : 1} 0 {section == "shell" ? 1 : 0} as tip
        global energy_error as energy_error
        global kinetic_energy as kinetic_energy
        global internal_energy as internal_energy
      end
    end
  end

  begin presto procedure hold
    begin procedural transfer
      include all blocks
    end

    begin time control
      begin time stepping block all
        start time = 1
        begin parameters for presto region hold
          step interval = 100
        end
      end
      termination time = 1.001
    end

    begin presto region hold
      use finite element model beam

      begin fixed displacement
        node set = clamped
        components = x y z
      end
{if(section == "shell")}
      begin fixed rotation
        node set = clamped
        components = x y z
      end
{endif}
      begin gravity
        include all blocks
        component = z
        gravitational constant = {weight}
        function = weight
        scale factor = -1
      end

      begin heartbeat output
        stream name = %B.csv
        append = on
        precision = 12
        at step 0 increment = 1
        nodal displacement(z) nearest location {section == "shell" ? 0 : 1} 0 {section == "shell" ? 1 : 0} as tip
        global energy_error as energy_error
        global kinetic_energy as kinetic_energy
        global internal_energy as internal_energy
      end
    end
  end

  begin presto procedure release
    begin procedural transfer
      block = beam
    end

    begin time control
      begin time stepping block all
        start time = 1.001
        begin parameters for presto region swing
          step interval = 1000
        end
      end
      termination time = 1.041
    end

    begin presto region swing
      use finite element model beam

      begin fixed displacement
        node set = clamped
        components = x y z
      end
{if(section == "shell")}
      begin fixed rotation
        node set = clamped
        components = x y z
      end
{endif}

      begin heartbeat output
        stream name = %B.csv
        append = on
        precision = 12
        at step 0 increment = 5
        nodal displacement(z) nearest location {section == "shell" ? 0 : 1} 0 {section == "shell" ? 1 : 0} as tip
        global energy_error as energy_error
        global kinetic_energy as kinetic_energy
        global internal_energy as internal_energy
      end
    end
  end
end sierra
