// library_names: functions as declared for double; those for float and long double end in f and l.
#include "emit/text/library_names.hpp"

#include <string>

namespace elgen {
namespace {

constexpr std::string_view names =
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

/// Those of <unistd.h>, which programs that control something include, and the program itself.
constexpr std::string_view system_names =
    " access acct alarm brk chdir chown chroot close close_range closefrom confstr crypt "
    "daemon dup dup2 dup3 eaccess endusershell euidaccess execl execle execlp execv execve "
    "execveat execvp execvpe faccessat fchdir fchown fchownat fdatasync fexecve fork "
    "fpathconf fsync ftruncate ftruncate64 get_current_dir_name getcwd getdomainname "
    "getdtablesize getegid geteuid getgid getgroups gethostid gethostname getlogin "
    "getlogin_r getopt getpagesize getpass getpgid getpgrp getpid getppid getresgid "
    "getresuid getsid gettid getuid getusershell getwd group_member isatty lchown link "
    "linkat lockf lockf64 lseek lseek64 nice pathconf pause pipe pipe2 pread pread64 profil "
    "pwrite pwrite64 read readlink readlinkat revoke rmdir sbrk setdomainname setegid "
    "seteuid setgid sethostid sethostname setlogin setpgid setpgrp setregid setresgid "
    "setresuid setreuid setsid setuid setusershell sleep swab symlink symlinkat sync syncfs "
    "syscall sysconf tcgetpgrp tcsetpgrp truncate truncate64 ttyname ttyname_r ttyslot "
    "ualarm unlink unlinkat usleep vfork vhangup write "
    "main ";

bool has_word(std::string_view words, std::string_view name) {
  return words.find(" " + std::string(name) + " ") != std::string_view::npos;
}

bool is_declared(std::string_view name) { return has_word(names, name); }

}  // namespace

bool is_reserved_type(std::string_view name) { return name.ends_with("_t"); }

bool is_library_name(std::string_view name) {
  const bool has_suffix = name.ends_with('f') || name.ends_with('l');
  return is_reserved_type(name) || is_declared(name) || has_word(system_names, name) ||
         (has_suffix && is_declared(name.substr(0, name.size() - 1)));
}

}  // namespace elgen
