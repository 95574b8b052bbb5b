// expect: offset: base plus the largest value does not fit the packet's field
#include "small_table.hpp"

struct narrow {
    std::uint8_t index{};
    std::uint32_t subindex{}, spare{}, count{};
};
template <> struct jauscat::wire::schema<narrow> {
    using T = narrow;
    using type =
        layout<field<&T::index, u8>, field<&T::subindex, u32le>, field<&T::spare, u32le>, field<&T::count, u32le>>;
};

using namespace small;

using wrong =
    translate::table<head, narrow, 100, translate::offset<at<&head::component>, at<&narrow::index>, 16>,
                     translate::code_rank<at<&head::code>, at<&narrow::subindex>, codes>, size_row,
                     translate::constant<at<&narrow::spare>, 0>, translate::data_count<at<&narrow::count>>, rest_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
