// expect: table: the packet field that counts the data is too narrow for the largest data
#include "small_table.hpp"

struct narrow {
    std::uint32_t index{}, subindex{}, spare{};
    std::uint8_t count{};
};
template <> struct jauscat::wire::schema<narrow> {
    using T = narrow;
    using type =
        layout<field<&T::index, u32le>, field<&T::subindex, u32le>, field<&T::spare, u32le>, field<&T::count, u8>>;
};

using namespace small;

using wrong =
    translate::table<head, narrow, 256, translate::offset<at<&head::component>, at<&narrow::index>, 6900>,
                     translate::code_rank<at<&head::code>, at<&narrow::subindex>, codes>, size_row,
                     translate::constant<at<&narrow::spare>, 0>, translate::data_count<at<&narrow::count>>, rest_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
