// SPDX-License-Identifier: BSD-3-Clause
// What sanitizers ask a program for; without them nothing calls these.

// An allocation of more than that is an error, a failed malloc of a library gives it null.
extern "C" __attribute__((used)) const char* __asan_default_options() {
  return "allocator_may_return_null=1:max_allocation_size_mb=2048:hard_rss_limit_mb=4096:detect_stack_use_"
         "after_return=0:handle_"
         "abort=1";
}

extern "C" __attribute__((used)) const char* __ubsan_default_options() { return "print_stacktrace=1"; }

// What the libraries of the files lose when they give a damaged one up, and what OpenMP keeps for its
// threads.
extern "C" __attribute__((used)) const char* __lsan_default_suppressions() {
  return "leak:libhdf5\nleak:libnetcdf\nleak:libomp\nleak:libgomp\n";
}
