// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/region_commands.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("element death needs elements, a criterion and known materials", "[parser][region]") {
  CHECK(
      name_messages(
          "begin element death d\n block = b\n criterion is always true\nend\n"
          "begin element death e\n include blocks with material = STEEL\n death on inversion = on\nend\n") ==
      "");
  CHECK(name_messages("begin element death d\nend\n") ==
        "a.i:1:21: error: the element death 'd' picks no elements; give it INCLUDE ALL BLOCKS, NODE SET, "
        "SURFACE, BLOCK, ASSEMBLY, RIGID BODY, NODE, ELEMENT or INCLUDE BLOCKS WITH MATERIAL\n"
        "a.i:1:21: error: the element death 'd' has no criterion; give it a CRITERION line\n");
  CHECK(
      name_messages(
          "begin element death d\n include blocks with material = steal\n criterion is always true\nend\n") ==
      "a.i:2:33: error: unknown material 'steal'; did you mean 'steel'?\n");
}

TEST_CASE("a spot weld needs nodes, faces and a function that is defined", "[parser][region]") {
  CHECK(name_messages(
            "begin spot weld w\n node set = n\n surface = s\n normal displacement function = f\nend\n") ==
        "");
  CHECK(
      name_messages("begin spot weld w\n node set = n\n surface = s\n tangential displacement function = ff\n"
                    " failure function = gg\nend\n") ==
      "a.i:4:37: error: unknown function 'ff'; did you mean 'f'?\n"
      "a.i:5:21: error: unknown function 'gg'; did you mean 'g'?\n");
  CHECK(
      name_messages("begin spot weld w\nend\n") ==
      "a.i:1:17: error: the spot weld 'w' has no NODE SET; add NODE SET = <node set> ...\n"
      "a.i:1:17: error: the spot weld 'w' has no SURFACE; add SURFACE = <side set> ...\n"
      "a.i:1:17: error: the spot weld 'w' has no DISPLACEMENT FUNCTION, normal or tangential; give it NORMAL "
      "DISPLACEMENT FUNCTION or TANGENTIAL DISPLACEMENT FUNCTION\n");
}

TEST_CASE("mass scaling needs a set and a target", "[parser][region]") {
  CHECK(name_messages("begin mass scaling\nend\n") ==
        "a.i:1:1: error: the mass scaling picks no part of the mesh; give it INCLUDE ALL BLOCKS, NODE SET, "
        "SURFACE, BLOCK, ASSEMBLY, RIGID BODY, NODE or ELEMENT\n"
        "a.i:1:1: error: the mass scaling has no TARGET TIME STEP; add TARGET TIME STEP = <real > 0>\n");
}

TEST_CASE("schedulers of every output and functions of user output are looked up", "[parser][region]") {
  CHECK(name_messages("begin results output\n use output scheduler OFTEN\nend\n"
                      "begin results output\n use output scheduler oftn\nend\n"
                      "begin history output\n use output scheduler oftn\nend\n"
                      "begin heartbeat output\n use output scheduler oftn\nend\n"
                      "begin restart data\n use output scheduler oftn\nend\n"
                      "begin user output\n compute nodal a as function ff\nend\n") ==
        "a.i:5:23: error: unknown output scheduler 'oftn'; did you mean 'often'?\n"
        "  3 more like this, at a.i:8:23, a.i:11:23, a.i:14:23\n"
        "a.i:17:30: error: unknown function 'ff'; did you mean 'f'?\n");
}

TEST_CASE("user variables and analytic objects have names of their own", "[parser][region]") {
  CHECK(name_messages("begin user variable v\nend\nbegin user variable V\nend\n"
                      "begin analytic object a\n normal direction = 1 0 0\nend\n"
                      "begin analytic object a\n normal direction = 1 0 0\nend\n") ==
        "a.i:3:21: error: the user variable 'V' is defined a second time; the first stands at a.i:1:21\n"
        "a.i:8:23: error: the analytic object 'a' is defined a second time; the first stands at a.i:5:23\n");
}

TEST_CASE("an analytic object needs a normal", "[parser][region]") {
  CHECK(
      name_messages("begin analytic object floor\n type = plane\n origin = 0 0 1\nend\n") ==
      "a.i:1:23: error: the analytic object 'floor' has no NORMAL DIRECTION; add NORMAL DIRECTION = <x> <y> "
      "<z>\n");
  // A normal that is written and wrong is said to be so besides.
  CHECK(name_messages("begin analytic object floor\n normal direction = 0 0 0\nend\n").find("a.i:2:") == 0);
}

TEST_CASE("mass properties of everything are fine", "[parser][region]") {
  CHECK(name_messages("begin mass properties\nend\n") == "");
  CHECK(name_messages("begin mass properties\n rigid body = body\nend\n") ==
        "a.i:2:15: error: unknown rigid body 'body'; the deck has rb\n");
}
