// cpp_names: the names in templates/cpp/ with which a user's name could collide, and E701 for a
// model that uses one of them. Names of a Model or Scene are never keywords or macros (E204).
#include "emit/cpp/cpp_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "base/ascii.hpp"
#include "base/reason.hpp"
#include "emit/code/cpp_constant.hpp"
#include "emit/interface/code_interface.hpp"
#include "emit/text/emission_checks.hpp"
#include "emit/text/emission_input.hpp"
#include "emit/text/layout.hpp"

namespace elgen {
namespace {

constexpr std::array<std::string_view, 24> emitted_names{
    "Accelerations",    "Coordinates",       "Forces",           "InputMatrix",
    "Inputs",           "Interval",          "Parameters",       "Scalar",
    "SquareMatrix",     "Velocities",        "constant",         "coordinate_count",
    "coordinate_names", "coordinate_ranges", "coordinate_units", "detail",
    "input_count",      "input_limits",      "input_names",      "input_units",
    "is_regular",       "parameter_count",   "rate_ranges",      "std"};
constexpr std::array<std::string_view, 17> more_emitted_names{
    "unbounded",        "velocity_count",   "velocity_names",   "velocity_units",    "result",
    "OpenValues",       "open_value_count", "open_value_names", "open_value_units",  "Momenta",
    "constraint_count", "Multipliers",      "constraint_names", "start_coordinates", "start_rates",
    "regressor_names",  "digits_left"};
constexpr std::array<std::string_view, 5> eigen_names{"eigen", "Eigen", "Argument", "Matrix",
                                                      "Vector"};
/// Names that the initialisers of the members of Parameters use. A member with one of these names
/// would hide the used name.
constexpr std::array<std::string_view, 5> names_in_initialisers{"Parameters", "Scalar", "constant",
                                                                "detail", "std"};
constexpr std::string_view constant_prefix = "number_";

template <class List>
bool contains(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

/// Functions of <math.h> and <stdlib.h> for double; their versions for float and long double end in
/// f and l.
constexpr std::string_view math_function_names =
    " a64l abort abs acos acosh alloca arc4random asin asinh atan atan2 atanh atexit atof "
    "atoi atol atoll bsearch calloc canonicalize cbrt ceil clearenv copysign cos cosh div "
    "drand48 drem ecvt erand48 erf erfc exit exp exp10 exp2 expm1 fabs fadd fcvt fdim fdiv "
    "ffma finite floor fma fmax fmaximum fmaxmag fmin fminimum fminmag fmod fmul free frexp "
    "fromfp fromfpx fsqrt fsub gamma gcvt getenv getloadavg getpayload getpt getsubopt "
    "grantpt hypot ilogb initstate iscanonical iseqsig isinf isnan issignaling iszero j0 j1 "
    "jn jrand48 l64a labs lcong48 ldexp ldiv lgamma llabs lldiv llogb llrint llround log "
    "log10 log1p log2 logb lrand48 lrint lround malloc mblen mbstowcs mbtowc mkdtemp "
    "mkostemp mkstemp mktemp modf mrand48 nan nearbyint nextafter nextdown nexttoward nextup "
    "nrand48 pow pselect ptsname putenv qecvt qfcvt qgcvt qsort rand random realloc "
    "reallocarray realpath remainder remquo rint round roundeven rpmatch scalb scalbln "
    "scalbn seed48 select setenv setpayload setstate significand sin sincos sinh sqrt srand "
    "srand48 srandom strtod strtof strtol strtold strtoll strtoq strtoul strtoull strtouq "
    "system tan tanh tgamma timespec timeval totalorder trunc ufromfp ufromfpx uint ulong "
    "unlockpt unsetenv ushort valloc wcstombs wctomb y0 y1 yn ";

/// Names that the other headers of C and POSIX declare.
constexpr std::string_view system_names =
#include "emit/cpp/library_names.def"
    ;

constexpr std::array<std::string_view, 16> reserved_prefixes{
    "aio_",   "epoll_",   "eventfd_", "inet_", "inet6_",    "inotify_", "isw", "mq_",
    "posix_", "pthread_", "sched_",   "sem_",  "sockaddr_", "timerfd_", "wcs", "wmem"};
constexpr std::array<std::string_view, 3> reserved_suffixes{"_t", "printf", "scanf"};

bool is_math_function(std::string_view name) { return has_word(math_function_names, name); }

/// True if C or POSIX reserves all names of this form, for types or for functions.
bool is_reserved_family(std::string_view name) {
  return std::ranges::any_of(reserved_suffixes,
                             [&](auto suffix) { return name.ends_with(suffix); }) ||
         std::ranges::any_of(reserved_prefixes,
                             [&](auto prefix) { return name.starts_with(prefix); });
}

/// True for names that a header of C or POSIX declares: no namespace can have them.
bool is_library_name(std::string_view name) {
  const bool has_suffix = name.ends_with('f') || name.ends_with('l');
  return is_reserved_family(name) || is_math_function(name) || has_word(system_names, name) ||
         (has_suffix && is_math_function(name.substr(0, name.size() - 1)));
}

/// Reports E912 if two constants get the same name.
Diagnostics check_constant_names(const Program& program) {
  std::map<std::string, ConstantForm> forms;
  for (const Constant& constant : executed_constants(program)) {
    if (is_short_constant(constant.value)) continue;
    const auto [known, is_new] = forms.emplace(constant_name(constant), constant.form);
    if (is_new) continue;
    return {{Reason::equal_constant_names,
             {},
             fmt::format("`{}` and `{}` have one name in the emitted code", text_of(known->second),
                         text_of(constant.form))}};
  }
  return {};
}

}  // namespace

bool is_reserved_by_system(std::string_view name) { return name == "std" || is_library_name(name); }

Diagnostics cpp_check_names(const Model& model, const Scene& scene, const Program& program) {
  Diagnostics diagnostics = check_constant_names(program);
  for (const ParameterArray& array : emitted_parameters(model, program)) {
    if (contains(names_in_initialisers, array.name)) {
      diagnostics.push_back(reserved_name_error(array.name, "parameter", array.span));
    }
  }
  std::map<std::string, std::string> structs;
  for (const Function& function : program.functions) {
    const std::string type = camel_case(function.name);
    const bool collides = returns_struct(function) &&
                          (is_emitted_name(type) || !structs.emplace(type, function.name).second);
    if (collides || is_emitted_name(function.name)) {
      diagnostics.push_back(reserved_name_error(scene, function));
    }
  }
  const std::string& outermost = name_space(scene);
  if (is_reserved_by_system(outermost)) {
    diagnostics.push_back(
        {Code::E701, scene.emission.name_space_span,
         fmt::format("`{}` cannot name a namespace: C or POSIX {}", outermost,
                     is_reserved_family(outermost) ? "reserves names like it" : "declares it"),
         "choose another with `[emit] namespace` of a scene"});
  }
  return diagnostics;
}

Diagnostics eigen_check_names(const Model& /*model*/, const Scene& scene, const Program& program) {
  Diagnostics diagnostics;
  for (const Function& function : program.functions) {
    const bool takes_struct = returns_struct(function) && is_eigen_name(camel_case(function.name));
    if (!takes_struct && !is_eigen_name(function.name)) continue;
    diagnostics.push_back(reserved_name_error(scene, function));
  }
  return diagnostics;
}

bool is_emitted_name(std::string_view name) {
  return contains(emitted_names, name) || contains(more_emitted_names, name) ||
         name.substr(0, constant_prefix.size()) == constant_prefix;
}

bool is_eigen_name(const std::string& name) { return contains(eigen_names, name); }

}  // namespace elgen
