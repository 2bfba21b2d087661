#pragma once

// The language that the headers are written in. Every header includes this one, directly or through
// others, but for the checker's, which stands apart. A header that does not exist ends the
// compilation at once, in one line; #error does not.

#if __cplusplus < 202002L
#include <Polhode needs C++20: compile with -std=c++20>
#endif
