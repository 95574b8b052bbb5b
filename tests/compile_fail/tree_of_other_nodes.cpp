// expect: tree: the member must be a list of nodes
#include "small_message.hpp"

struct node {
    std::uint8_t children{};
};
struct planted {
    jauscat::wire::list<small_message> tree{};
};

template <> struct jauscat::wire::schema<node> {
    using type = layout<field<&node::children, u8>>;
};
template <> struct jauscat::wire::schema<planted> {
    using type = layout<tree<&planted::tree, &node::children, 4>>;
};

static_assert(size_of_wrong<planted> != 0);
