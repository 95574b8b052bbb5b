#include "small_table.hpp"

using namespace small;

struct good_row {
    using uses = translate::path_list<>;
    using writes = translate::path_list<at<&packet::spare>>;
    static constexpr translate::errc to_packet(const auto&, auto& packet, translate::sizes) noexcept {
        packet.spare = 0;
        return translate::errc::ok;
    }
    static constexpr translate::errc from_packet(const auto&, auto&, translate::sizes) noexcept {
        return translate::errc::ok;
    }
};

// A case hides what it has otherwise than `good_row`.
#ifdef GOOD
// expect: no error
using row = good_row;
static_assert(translate::row<row, head, packet>);
#endif

#ifdef FROM_PACKET_RESULT
// expect: table: a row has no static from_packet(const auto& packet, auto& message, sizes) noexcept that returns an
// errc
struct row : good_row {
    static constexpr bool from_packet(const auto&, auto&, translate::sizes) noexcept { return true; }
};
#endif

#ifdef WITHOUT_FROM_PACKET
// expect: table: a row has no static from_packet(const auto& packet, auto& message, sizes) noexcept that returns an
// errc
struct row : good_row {
    static void from_packet(const auto&, auto&, translate::sizes) = delete;
};
#endif

#ifdef TO_PACKET_PARAMETERS
// expect: table: a row has no static to_packet(const auto& message, auto& packet, sizes) noexcept that returns an errc
struct row : good_row {
    static constexpr translate::errc to_packet(const auto&, auto&) noexcept { return translate::errc::ok; }
};
#endif

#ifdef TO_PACKET_THROWS
// expect: table: a row has no static to_packet(const auto& message, auto& packet, sizes) noexcept that returns an errc
struct row : good_row {
    static constexpr translate::errc to_packet(const auto&, auto&, translate::sizes) { return translate::errc::ok; }
};
#endif

#ifdef USES_NO_LIST
// expect: table: a row has no path_list `uses`
struct row : good_row {
    using uses = void;
};
#endif

#ifdef WRITES_NO_LIST
// expect: table: a row has no path_list `writes`
struct row : good_row {
    using writes = at<&packet::spare>;
};
#endif

#ifdef OF_NO_PATH
// expect: path_list: a row names what is no field; write at<&T::member>
using row = translate::caller_set<packet>;
#endif

using table_with_it = table_of<index_row, subindex_row, size_row, row, count_row, rest_row>;
static_assert(error_of_nothing<table_with_it>() == translate::errc::truncated);
