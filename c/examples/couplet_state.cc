// [mode, text] = couplet_state(weight, half_opening, friction, digits): the mode and the least thickness of an arch as texts; an
// error with couplet's sentence if it has none.
//
//     mkoctfile couplet_state.cc -I target/c/include -L target/c/lib -lcouplet_c -Wl,-rpath,target/c/lib

#include <couplet_c.h>
#include <octave/oct.h>

DEFUN_DLD(couplet_state, arguments, , "[mode, text] = couplet_state(weight, half_opening, friction, digits)") {
  if (arguments.length() != 4) {
    print_usage();
  }
  couplet_answer *answer;
  int code = couplet_state(arguments(0).xstring_value("weight is a text").c_str(),
                           arguments(1).xstring_value("half_opening is a text").c_str(),
                           arguments(2).xstring_value("friction is a text").c_str(),
                           arguments(3).xidx_type_value("digits are a whole number"), &answer);
  const std::string mode = couplet_mode(answer), reason = couplet_reason(answer);
  const std::string text = couplet_text(answer, "thickness", COUPLET_VALUE);
  couplet_free(answer);
  if (code != COUPLET_PROVED || text.empty()) {
    error("couplet: %s", reason.c_str());
  }
  return ovl(mode, text);
}
