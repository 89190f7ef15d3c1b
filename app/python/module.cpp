// SPDX-License-Identifier: BSD-3-Clause
#include "app/python/bindings.hpp"

PYBIND11_MODULE(native, module) {
  contactsim::bind_errors(module);
  contactsim::bind_mesh(module);
  contactsim::bind_results(module);
  contactsim::bind_run(module);
}
