# Two elastic cubes of one block, of 2 x 2 x 2 and 3 x 3 x 3 cells, fly at each other with 0.5 m/s each, off their middle, and
# bounce: contact of a surface with itself (SI, E = 10 MPa, density 1000). With -D enforcement=penalty by elastic penalties.
#
# Shows self contact of hexahedra and, split, of ten-node tetrahedra, whose faces meet by four facets each. Expected: nothing
# deeper than 1 % of a cell of 0.5 m at any time, they part, and the momentum stays 0 within 1e-9 of that of a cube.
#
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {ifndef(enforcement)}
# {enforcement = "momentum_balance"}
# {endif}
begin sierra self contact
  begin material m
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e7
      poissons ratio = 0.3
    end
  end
  begin finite element model f
    database name = self_contact.g
    begin parameters for block bar
      material = m
      model = elastic
    end
  end
  begin presto procedure p
    begin time control
      begin time stepping block t
        start time = 0
        begin parameters for presto region r
        end
      end
      termination time = 0.3
    end
    begin presto region r
      use finite element model f
      begin initial velocity
        node set = left
        component = x
        magnitude = 0.5
      end
      begin initial velocity
        node set = right
        component = x
        magnitude = -0.5
      end
      begin contact definition
        skin all blocks = on
        begin interaction defaults
          general contact = off
          self contact = on
          constraint formulation = {form}
          enforcement = {enforcement}
        end
      end
      begin user output
        node set = left
        compute global vl as average of nodal velocity(x)
        compute global xl as max of nodal coordinates(x)
      end
      begin user output
        node set = right
        compute global vr as average of nodal velocity(x)
        compute global xr as min of nodal coordinates(x)
      end
      begin heartbeat output
        stream name = %B.csv
        precision = 15
        at step 0 increment = 10
        global vl vr xl xr energy_error kinetic_energy contact_penetration_max momentum
      end
    end
  end
end sierra
