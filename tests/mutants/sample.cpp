// Prints what the functions of sample.hpp return.
#include <jauscat/sample/sample.hpp>

#include <cstdio>

int main() {
    using namespace jauscat::sample;
    std::printf("%d%d%d ", is_below(1, 2), is_below(2, 2), is_below(3, 2));
    std::printf("%d%d%d ", equals({1, 2}, {1, 2}), equals({1, 2}, {1, 3}), equals({1, 2}, {3, 2}));
    std::printf("%d %d ", swapped(5, 3), doubled(4));
    std::printf("%d%d ", static_cast<int>(next(colour::red)), static_cast<int>(next(colour::green)));
    for (const int value : {1, 2, 3}) std::printf("%d ", found(value).value_or(-1));
    std::printf("%d %zu\n", made_by_compiler(0), size_of_array());
}
