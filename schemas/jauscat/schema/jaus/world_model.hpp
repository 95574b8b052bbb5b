// World Model subgroup of RA 3.3 part 3: objects of a vector knowledge store (VKS).
#pragma once
#include <jauscat/schema/jaus/types.hpp>
#include <jauscat/wire/schema.hpp>

namespace jauscat::jaus {

/// Terminate Vector Knowledge Store Data Transfer: stops the reports in progress. Code 0A24h, command class, no body.
struct terminate_vector_knowledge_store_data_transfer {
    static constexpr std::uint16_t command_code = 0x0A24;
    friend constexpr bool operator==(const terminate_vector_knowledge_store_data_transfer&,
                                     const terminate_vector_knowledge_store_data_transfer&) = default;
};

/// Query Vector Knowledge Store Feature Class Metadata. Code 2A21h, query class, 2 bytes.
struct query_vector_knowledge_store_feature_class_metadata {
    static constexpr std::uint16_t command_code = 0x2A21;
    std::uint16_t feature_class_id{}; ///< the class
    friend constexpr bool operator==(const query_vector_knowledge_store_feature_class_metadata&,
                                     const query_vector_knowledge_store_feature_class_metadata&) = default;
};

/// Query Vector Knowledge Store Bounds. Code 2A22h, query class, 3 bytes.
struct query_vector_knowledge_store_bounds {
    static constexpr std::uint16_t command_code = 0x2A22;
    std::uint8_t local_request_id{};  ///< returned with the answer
    std::uint16_t feature_class_id{}; ///< the class
    friend constexpr bool operator==(const query_vector_knowledge_store_bounds&,
                                     const query_vector_knowledge_store_bounds&) = default;
};

/// Report Vector Knowledge Store Bounds: the corners of the area that a feature class covers.
/// Code 4A22h, inform class, 19 bytes.
struct report_vector_knowledge_store_bounds {
    static constexpr std::uint16_t command_code = 0x4A22;
    std::uint8_t local_request_id{};  ///< of the request
    std::uint16_t feature_class_id{}; ///< the class
    double southwest_latitude{};      ///< degrees (WGS 84), -90 to 90
    double southwest_longitude{};     ///< degrees (WGS 84), -180 to 180
    double northeast_latitude{};      ///< degrees (WGS 84), -90 to 90
    double northeast_longitude{};     ///< degrees (WGS 84), -180 to 180
    friend constexpr bool operator==(const report_vector_knowledge_store_bounds&,
                                     const report_vector_knowledge_store_bounds&) = default;
};

/// Report Vector Knowledge Store Data Transfer Termination: the reports are stopped. Code 4A24h, inform class, no body.
struct report_vector_knowledge_store_data_transfer_termination {
    static constexpr std::uint16_t command_code = 0x4A24;
    friend constexpr bool operator==(const report_vector_knowledge_store_data_transfer_termination&,
                                     const report_vector_knowledge_store_data_transfer_termination&) = default;
};

} // namespace jauscat::jaus

// One line per field, as in the standard's table.
// clang-format off
namespace jauscat {

template <> struct wire::schema<jaus::terminate_vector_knowledge_store_data_transfer> { using type = layout<>; };

template <> struct wire::schema<jaus::query_vector_knowledge_store_feature_class_metadata> {
    using T = jaus::query_vector_knowledge_store_feature_class_metadata;
    using type = layout<field<&T::feature_class_id, u16le>>;
};

template <> struct wire::schema<jaus::query_vector_knowledge_store_bounds> {
    using T = jaus::query_vector_knowledge_store_bounds;
    using type = layout<
        field<&T::local_request_id, u8>,
        field<&T::feature_class_id, u16le>>;
};

template <> struct wire::schema<jaus::report_vector_knowledge_store_bounds> {
    using T = jaus::report_vector_knowledge_store_bounds;
    using type = layout<
        field<&T::local_request_id, u8>,
        field<&T::feature_class_id, u16le>,
        field<&T::southwest_latitude, scaled<i32le, jaus::latitude_range>>,
        field<&T::southwest_longitude, scaled<i32le, jaus::longitude_range>>,
        field<&T::northeast_latitude, scaled<i32le, jaus::latitude_range>>,
        field<&T::northeast_longitude, scaled<i32le, jaus::longitude_range>>>;
};

template <> struct wire::schema<jaus::report_vector_knowledge_store_data_transfer_termination> { using type = layout<>; };

} // namespace jauscat
