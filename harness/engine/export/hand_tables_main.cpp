// twiddle-hand-tables: print the controller's tables of the hand in a URDF.
#include "hand_tables.hpp"

#include <exception>
#include <iostream>

int main(int argc, char **argv)
{
    if (argc != 2) {
        std::cerr << "twiddle-hand-tables: expected one argument, the hand's URDF; the tables go to standard output\n";
        return 2;
    }
    try {
        std::cout << twiddle::engine::hand_tables(twiddle::sim::read_hand_model(argv[1])) << std::flush;
    } catch (const std::exception &error) {
        std::cerr << "twiddle-hand-tables: " << error.what() << '\n';
        return 1;
    }
    return std::cout ? 0 : 1;
}
