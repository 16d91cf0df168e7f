// The elimination that several folders ask for is compiled once.
#include "numbers/echelon.hpp"

namespace elgen {

template class Echelon<LargestPivot<cln::cl_R, EchelonForm::reduced>>;

}  // namespace elgen
