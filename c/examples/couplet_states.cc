// [verdict, mode, values] = couplet_states(weight, half_opening, friction, quantities): the states of arrays of arches;
// values(:, 1, q) are the nearest doubles of quantity q, values(:, 2, q) and values(:, 3, q) its bounds. The modes are texts.
//
//     mkoctfile couplet_states.cc -I target/c/include -L target/c/lib -lcouplet_c -Wl,-rpath,target/c/lib

#include <algorithm>
#include <couplet_c.h>
#include <octave/oct.h>
#include <octave/Cell.h>
#include <vector>

DEFUN_DLD(couplet_states, arguments, , "[verdict, mode, values] = couplet_states(weight, half_opening, friction, quantities)") {
  if (arguments.length() != 4) {
    print_usage();
  }
  const std::string weight = arguments(0).xstring_value("weight is a text");
  const NDArray half_opening = arguments(1).xarray_value("half_opening is an array");
  const NDArray friction = arguments(2).xarray_value("friction is an array");
  const std::string quantities = arguments(3).xstring_value("quantities are a text");
  const octave_idx_type n = half_opening.numel();
  if (friction.numel() != n) {
    error("couplet: half_opening and friction have different lengths");
  }
  const octave_idx_type count = quantities.empty() ? 0 : 1 + std::count(quantities.begin(), quantities.end(), ',');
  uint8NDArray verdict(dim_vector(n, 1));
  NDArray values(dim_vector(n, 3, count));
  std::vector<uint8_t> codes(n), modes(n);
  couplet_answer *answer;
  int code = couplet_states(weight.c_str(), n, half_opening.data(), friction.data(), nullptr, quantities.c_str(), 0,
                            codes.data(), modes.data(), values.fortran_vec(), &answer);
  const std::string reason = couplet_reason(answer);
  couplet_free(answer);
  if (code > COUPLET_OPEN) {
    error("couplet: %s", reason.c_str());
  }
  Cell mode(dim_vector(n, 1));
  for (octave_idx_type i = 0; i < n; i++) {
    verdict(i) = octave_uint8(codes[i]);
    mode(i) = couplet_mode_name(modes[i]);
  }
  return ovl(verdict, mode, values);
}
