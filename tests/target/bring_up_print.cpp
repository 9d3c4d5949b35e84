// Prints the table of kernel/examples/bring_up on an emulated board.

#include <board/console.hpp>

extern "C" void bring_up_print(const char* table) { impact::board::print(table); }
