// Wrench efforts in the process image: Set Wrench Effort into a slave's outputs (RxPDO), Report Wrench Effort out of
// its inputs (TxPDO). One layout serves both directions; the slave copies its values in force to its inputs.
#pragma once
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/translate/image_table.hpp>

// One line per field, as in the image.
// clang-format off
namespace jauscat::translation {

/// Twelve efforts as JAUS has them on the wire (-32767 to 32767 is -100 to 100 %, 0 to 255 is 0 to 100 %). 22 bytes.
struct wrench_effort_image {
    /// Outputs: incremented by each command, 0 before the first. Inputs: that of the last command that the slave has
    /// executed.
    std::uint16_t command_count{};
    /// Outputs: the elements that the last command had. Inputs: the elements that the slave has. Bits as in the
    /// message.
    std::uint16_t presence_vector{};
    std::int16_t propulsive_linear_effort_x{};
    std::int16_t propulsive_linear_effort_y{};
    std::int16_t propulsive_linear_effort_z{};
    std::int16_t propulsive_rotational_effort_x{};
    std::int16_t propulsive_rotational_effort_y{};
    std::int16_t propulsive_rotational_effort_z{};
    std::uint8_t resistive_linear_effort_x{};
    std::uint8_t resistive_linear_effort_y{};
    std::uint8_t resistive_linear_effort_z{};
    std::uint8_t resistive_rotational_effort_x{};
    std::uint8_t resistive_rotational_effort_y{};
    std::uint8_t resistive_rotational_effort_z{};
    friend constexpr bool operator==(const wrench_effort_image&, const wrench_effort_image&) = default;

    struct schema : wire::items {
        using T = wrench_effort_image;
        using type = layout<
            field<&T::command_count, u16le>,
            field<&T::presence_vector, u16le>,
            field<&T::propulsive_linear_effort_x, i16le>,
            field<&T::propulsive_linear_effort_y, i16le>,
            field<&T::propulsive_linear_effort_z, i16le>,
            field<&T::propulsive_rotational_effort_x, i16le>,
            field<&T::propulsive_rotational_effort_y, i16le>,
            field<&T::propulsive_rotational_effort_z, i16le>,
            field<&T::resistive_linear_effort_x, u8>,
            field<&T::resistive_linear_effort_y, u8>,
            field<&T::resistive_linear_effort_z, u8>,
            field<&T::resistive_rotational_effort_x, u8>,
            field<&T::resistive_rotational_effort_y, u8>,
            field<&T::resistive_rotational_effort_z, u8>>;
    };
};

/// A wrench effort message `M` and the image; `Count` is the row for the command counter.
template <class M, class Count> struct wrench_effort_table_of {
    using P = wrench_effort_image;
    using type = translate::image_table<M, P,
        Count,
        translate::presence_bits<translate::at<&P::presence_vector>>,
        translate::element<translate::at<&M::propulsive_linear_effort_x>, translate::at<&P::propulsive_linear_effort_x>>,
        translate::element<translate::at<&M::propulsive_linear_effort_y>, translate::at<&P::propulsive_linear_effort_y>>,
        translate::element<translate::at<&M::propulsive_linear_effort_z>, translate::at<&P::propulsive_linear_effort_z>>,
        translate::element<translate::at<&M::propulsive_rotational_effort_x>, translate::at<&P::propulsive_rotational_effort_x>>,
        translate::element<translate::at<&M::propulsive_rotational_effort_y>, translate::at<&P::propulsive_rotational_effort_y>>,
        translate::element<translate::at<&M::propulsive_rotational_effort_z>, translate::at<&P::propulsive_rotational_effort_z>>,
        translate::element<translate::at<&M::resistive_linear_effort_x>, translate::at<&P::resistive_linear_effort_x>>,
        translate::element<translate::at<&M::resistive_linear_effort_y>, translate::at<&P::resistive_linear_effort_y>>,
        translate::element<translate::at<&M::resistive_linear_effort_z>, translate::at<&P::resistive_linear_effort_z>>,
        translate::element<translate::at<&M::resistive_rotational_effort_x>, translate::at<&P::resistive_rotational_effort_x>>,
        translate::element<translate::at<&M::resistive_rotational_effort_y>, translate::at<&P::resistive_rotational_effort_y>>,
        translate::element<translate::at<&M::resistive_rotational_effort_z>, translate::at<&P::resistive_rotational_effort_z>>>;
};
// clang-format on

/// Set Wrench Effort into the outputs.
using set_wrench_effort_table =
    wrench_effort_table_of<jaus::set_wrench_effort,
                           translate::counter<translate::at<&wrench_effort_image::command_count>>>::type;
/// Report Wrench Effort from the inputs; the slave's application sets the counter.
using report_wrench_effort_table =
    wrench_effort_table_of<jaus::report_wrench_effort,
                           translate::caller_set<translate::at<&wrench_effort_image::command_count>>>::type;

} // namespace jauscat::translation
