#include "polhode/expression/evaluation.hpp"

namespace polhode {

template class compiled_expression<jet<ball, 1>>;
template class compiled_expression<jet<ball, 2>>;
template class compiled_expression<jet<ball, 3>>;
template class compiled_expression<jet<ball, dynamic_order>>;

}  // namespace polhode
