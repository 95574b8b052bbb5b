#include "small_table.hpp"

using namespace small;

#ifdef GOOD
// expect: no error
struct zero {
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
static_assert(translate::row<zero, head, packet>);

using right = table_of<index_row, subindex_row, size_row, zero, count_row, rest_row>;
static_assert(error_of_nothing<right>() == translate::errc::truncated);
#endif

#ifdef FROM_PACKET_RESULT
// expect: table: a row has no static from_packet(const auto& packet, auto& message, sizes) noexcept that returns an
// errc
struct zero {
    using uses = translate::path_list<>;
    using writes = translate::path_list<at<&packet::spare>>;
    static constexpr translate::errc to_packet(const auto&, auto& packet, translate::sizes) noexcept {
        packet.spare = 0;
        return translate::errc::ok;
    }
    static constexpr bool from_packet(const auto&, auto&, translate::sizes) noexcept { return true; }
};
using wrong = table_of<index_row, subindex_row, size_row, zero, count_row, rest_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
#endif

#ifdef OF_NO_PATH
// expect: path_list: a row names what is no field; write at<&T::member>
using no_path = translate::caller_set<packet>;
using wrong = table_of<index_row, subindex_row, size_row, no_path, count_row, rest_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
#endif

#ifdef TO_PACKET_PARAMETERS
// expect: table: a row has no static to_packet(const auto& message, auto& packet, sizes) noexcept that returns an errc
struct zero {
    using uses = translate::path_list<>;
    using writes = translate::path_list<at<&packet::spare>>;
    static constexpr translate::errc to_packet(const auto&, auto&) noexcept { return translate::errc::ok; }
    static constexpr translate::errc from_packet(const auto&, auto&, translate::sizes) noexcept {
        return translate::errc::ok;
    }
};
using wrong = table_of<index_row, subindex_row, size_row, zero, count_row, rest_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
#endif

#ifdef TO_PACKET_THROWS
// expect: table: a row has no static to_packet(const auto& message, auto& packet, sizes) noexcept that returns an errc
struct zero {
    using uses = translate::path_list<>;
    using writes = translate::path_list<at<&packet::spare>>;
    static constexpr translate::errc to_packet(const auto&, auto&, translate::sizes) { return translate::errc::ok; }
    static constexpr translate::errc from_packet(const auto&, auto&, translate::sizes) noexcept {
        return translate::errc::ok;
    }
};
using wrong = table_of<index_row, subindex_row, size_row, zero, count_row, rest_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
#endif

#ifdef WITHOUT_FROM_PACKET
// expect: table: a row has no static from_packet(const auto& packet, auto& message, sizes) noexcept that returns an
// errc
struct zero {
    using uses = translate::path_list<>;
    using writes = translate::path_list<at<&packet::spare>>;
    static constexpr translate::errc to_packet(const auto&, auto& packet, translate::sizes) noexcept {
        packet.spare = 0;
        return translate::errc::ok;
    }
};
using wrong = table_of<index_row, subindex_row, size_row, zero, count_row, rest_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
#endif

#ifdef WITHOUT_USES
// expect: table: a row has no path_list `uses`
struct zero {
    using writes = translate::path_list<at<&packet::spare>>;
    static constexpr translate::errc to_packet(const auto&, auto& packet, translate::sizes) noexcept {
        packet.spare = 0;
        return translate::errc::ok;
    }
    static constexpr translate::errc from_packet(const auto&, auto&, translate::sizes) noexcept {
        return translate::errc::ok;
    }
};
using wrong = table_of<index_row, subindex_row, size_row, zero, count_row, rest_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
#endif

#ifdef WRITES_NO_LIST
// expect: table: a row has no path_list `writes`
struct zero {
    using uses = translate::path_list<>;
    using writes = at<&packet::spare>;
    static constexpr translate::errc to_packet(const auto&, auto& packet, translate::sizes) noexcept {
        packet.spare = 0;
        return translate::errc::ok;
    }
    static constexpr translate::errc from_packet(const auto&, auto&, translate::sizes) noexcept {
        return translate::errc::ok;
    }
};
using wrong = table_of<index_row, subindex_row, size_row, zero, count_row, rest_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
#endif
