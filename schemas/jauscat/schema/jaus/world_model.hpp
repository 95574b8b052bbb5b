// World Model subgroup of RA 3.3 part 3: objects of a vector knowledge store (VKS).
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/jaus/typed_value.hpp>
#include <jauscat/schema/jaus/types.hpp>
#include <jauscat/wire/schema.hpp>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::jaus {

/// Object Type: what the points of an object are.
enum class object_type : std::uint8_t {
    point = 0,
    line = 1,
    polygon = 2,
};

/// Region Type: what the points of a region are.
enum class region_type : std::uint8_t {
    point = 0,
    line = 1,
    polygon = 2,
};

/// A point of an object or region. 8 bytes.
struct vks_point {
    double latitude{};  ///< degrees (WGS 84), -90 to 90
    double longitude{}; ///< degrees (WGS 84), -180 to 180
    friend constexpr bool operator==(const vks_point&, const vks_point&) = default;

    struct schema : wire::items {
        using T = vks_point;
        using type = layout<
            field<&T::latitude, scaled<i32le, latitude_range>>,
            field<&T::longitude, scaled<i32le, longitude_range>>>;
    };
};

/// A class that an object belongs to. 3 to 11 bytes.
struct vks_feature_class {
    std::uint16_t feature_class_id{};      ///< names the class
    typed_value feature_class_attribute{}; ///< the object's value for that class
    friend constexpr bool operator==(const vks_feature_class&, const vks_feature_class&) = default;

    struct schema : wire::items {
        using T = vks_feature_class;
        using type = layout<
            field<&T::feature_class_id, u16le>,
            nested<&T::feature_class_attribute>>;
    };
};

/// A class that `Message` selects objects by. Bits 4 and 5 of its presence vector say for all classes what is there.
/// 0 to 11 bytes.
template <class Message> struct vks_feature_class_filter {
    std::optional<std::uint16_t> feature_class_id{};      ///< names the class
    std::optional<typed_value> feature_class_attribute{}; ///< the value that the objects have for that class
    friend constexpr bool operator==(const vks_feature_class_filter&, const vks_feature_class_filter&) = default;

    struct schema : wire::items {
        using T = vks_feature_class_filter<Message>;
        using type = layout<
            gated_by<&Message::feature_class_id_present, field<&T::feature_class_id, u16le>>,
            gated_by<&Message::feature_class_attribute_present, nested<&T::feature_class_attribute>>>;
    };
};

/// An object to create. 4 bytes or more.
struct new_vks_object {
    jaus::object_type object_type{};               ///< what the points are
    std::optional<float> object_buffer{};          ///< metres around the points that belong to the object
    wire::list<vks_feature_class> feature_class{}; ///< what the object is
    wire::list<vks_point> point{};                 ///< where it is
    friend constexpr bool operator==(const new_vks_object&, const new_vks_object&) = default;

    struct schema; ///< below the message, whose flag it goes by
};

/// An object of the store. 12 bytes or more.
struct vks_object {
    std::uint32_t object_id{};                     ///< the store's name for the object
    jaus::object_type object_type{};               ///< what the points are
    float object_buffer{};                         ///< metres around the points that belong to the object
    wire::list<vks_feature_class> feature_class{}; ///< what the object is
    wire::list<vks_point> point{};                 ///< where it is
    friend constexpr bool operator==(const vks_object&, const vks_object&) = default;

    struct schema : wire::items {
        using T = vks_object;
        using type = layout<
            field<&T::object_id, u32le>,
            field<&T::object_type, enumeration<jaus::object_type, u8>>,
            field<&T::object_buffer, in_units<f32le, metres>>,
            repeated<&T::feature_class, count<"number_of_feature_classes", u8>>,
            repeated<&T::point, count<"number_of_points", u16le>>>;
    };
};

/// Message Properties of Create Vector Knowledge Store Objects, by bit.
enum class create_objects_property : std::uint8_t {
    request_confirmation_of_object_creation = 0, ///< the store is to report the new objects' IDs
};

/// Create Vector Knowledge Store Objects: adds objects to the store.
/// Code 0A20h, command class, 5 bytes or more.
struct create_vector_knowledge_store_objects {
    bool object_buffer_present{};                                ///< each object has a buffer
    wire::bit_set<create_objects_property> message_properties{}; ///< how the store is to answer
    std::uint8_t local_request_id{};                             ///< returned with the answer
    wire::list<new_vks_object> object{};                         ///< what to add
    friend constexpr bool operator==(const create_vector_knowledge_store_objects&,
                                     const create_vector_knowledge_store_objects&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0A20;
        using T = create_vector_knowledge_store_objects;
        using type = layout<
            lenient_presence<u8,
                presence_flag<&T::object_buffer_present>,
                field<&T::message_properties, bit_set_codec<create_objects_property, u8>>,
                field<&T::local_request_id, u8>,
                repeated<&T::object, count<"number_of_objects", u16le>>>>;
    };
};

struct new_vks_object::schema : wire::items {
    using T = new_vks_object;
    using type = layout<
        field<&T::object_type, enumeration<jaus::object_type, u8>>,
        gated_by<&create_vector_knowledge_store_objects::object_buffer_present,
            field<&T::object_buffer, in_units<f32le, metres>>>,
        repeated<&T::feature_class, count<"number_of_feature_classes", u8>>,
        repeated<&T::point, count<"number_of_points", u16le>>>;
};

/// Metadata Options of Set Vector Knowledge Store Feature Class Metadata.
enum class metadata_options : std::uint8_t {
    append = 0,
    prepend = 1,
    overwrite = 2,
    erase = 255,
};

/// Set Vector Knowledge Store Feature Class Metadata: changes the text that describes a feature class.
/// Code 0A21h, command class, 5 bytes or more. A peer is known to send garbage in place of the text.
struct set_vector_knowledge_store_feature_class_metadata {
    jaus::metadata_options metadata_options{}; ///< where the text goes
    std::uint16_t feature_class_id{};          ///< the class
    std::string_view feature_class_metadata{}; ///< the text, up to 65535 characters
    friend constexpr bool operator==(const set_vector_knowledge_store_feature_class_metadata&,
                                     const set_vector_knowledge_store_feature_class_metadata&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0A21;
        using T = set_vector_knowledge_store_feature_class_metadata;
        using type = layout<
            field<&T::metadata_options, enumeration<jaus::metadata_options, u8>>,
            field<&T::feature_class_id, u16le>,
            string<&T::feature_class_metadata, count<"number_of_string_characters", u16le>>>;
    };
};

/// Terminate Vector Knowledge Store Data Transfer: stops the reports in progress. Code 0A24h, command class, no body.
struct terminate_vector_knowledge_store_data_transfer {
    friend constexpr bool operator==(const terminate_vector_knowledge_store_data_transfer&,
                                     const terminate_vector_knowledge_store_data_transfer&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0A24;
        using type = layout<>;
    };
};

/// Delete Vector Knowledge Store Objects: removes the objects that have all that is given.
/// Code 0A25h, command class, 2 bytes or more. A peer is known to send the region buffer by the region type's bit.
struct delete_vector_knowledge_store_objects {
    using feature_class_filter = vks_feature_class_filter<delete_vector_knowledge_store_objects>;
    std::uint8_t local_request_id{};                                 ///< returned with the answer
    std::optional<wire::list<std::uint32_t>> object_id{};            ///< the objects by name
    std::optional<jaus::region_type> region_type{};                  ///< what the region points are
    std::optional<float> region_buffer{};                            ///< metres around the region
    std::optional<wire::list<feature_class_filter>> feature_class{}; ///< what the objects are
    bool feature_class_id_present{};                                 ///< each feature class has its ID
    bool feature_class_attribute_present{};                          ///< each feature class has an attribute
    std::optional<wire::list<vks_point>> region_point{};             ///< where the objects are
    friend constexpr bool operator==(const delete_vector_knowledge_store_objects&,
                                     const delete_vector_knowledge_store_objects&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0A25;
        using T = delete_vector_knowledge_store_objects;
        using type = layout<
            lenient_presence<u8,
                field<&T::local_request_id, u8>,
                repeated<&T::object_id, count<"number_of_objects", u16le>, element<"object", u32le>>,
                field<&T::region_type, enumeration<jaus::region_type, u8>>,
                field<&T::region_buffer, in_units<f32le, metres>>,
                repeated<&T::feature_class, count<"number_of_feature_classes", u8>>,
                presence_flag<&T::feature_class_id_present>,
                presence_flag<&T::feature_class_attribute_present>,
                repeated<&T::region_point, count<"number_of_region_points", u16le>>>>;
    };
};

/// Query Vector Knowledge Store Feature Class Metadata: asks for the text that describes a feature class.
/// Code 2A21h, query class, 2 bytes.
struct query_vector_knowledge_store_feature_class_metadata {
    std::uint16_t feature_class_id{}; ///< the class
    friend constexpr bool operator==(const query_vector_knowledge_store_feature_class_metadata&,
                                     const query_vector_knowledge_store_feature_class_metadata&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2A21;
        using report = struct report_vector_knowledge_store_feature_class_metadata;
        using T = query_vector_knowledge_store_feature_class_metadata;
        using type = layout<field<&T::feature_class_id, u16le>>;
    };
};

/// Query Vector Knowledge Store Bounds: asks for the corners of the area that a feature class covers.
/// Code 2A22h, query class, 3 bytes.
struct query_vector_knowledge_store_bounds {
    std::uint8_t local_request_id{};  ///< returned with the answer
    std::uint16_t feature_class_id{}; ///< the class
    friend constexpr bool operator==(const query_vector_knowledge_store_bounds&,
                                     const query_vector_knowledge_store_bounds&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2A22;
        using report = struct report_vector_knowledge_store_bounds;
        using T = query_vector_knowledge_store_bounds;
        using type = layout<
            field<&T::local_request_id, u8>,
            field<&T::feature_class_id, u16le>>;
    };
};

/// Query Vector Knowledge Store Objects: requests the objects that match all given properties.
/// Code 2A23h, query class, 3 bytes or more. A peer is known to send the region buffer by the region type's bit.
struct query_vector_knowledge_store_objects {
    using feature_class_filter = vks_feature_class_filter<query_vector_knowledge_store_objects>;
    std::uint8_t report_presence_vector{}; ///< the requested fields of Report Vector Knowledge Store Objects
    std::uint8_t local_request_id{};       ///< returned with the answer
    std::optional<wire::list<std::uint32_t>> object_id{};            ///< the objects by name
    std::optional<jaus::region_type> region_type{};                  ///< what the region points are
    std::optional<float> region_buffer{};                            ///< metres around the region
    std::optional<wire::list<feature_class_filter>> feature_class{}; ///< what the objects are
    bool feature_class_id_present{};                                 ///< each feature class has its ID
    bool feature_class_attribute_present{};                          ///< each feature class has an attribute
    std::optional<wire::list<vks_point>> region_point{};             ///< where the objects are
    friend constexpr bool operator==(const query_vector_knowledge_store_objects&,
                                     const query_vector_knowledge_store_objects&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2A23;
        using report = struct report_vector_knowledge_store_objects;
        using T = query_vector_knowledge_store_objects;
        using type = layout<
            lenient_presence<u8,
                field<&T::report_presence_vector, u8>,
                field<&T::local_request_id, u8>,
                repeated<&T::object_id, count<"number_of_objects", u16le>, element<"object", u32le>>,
                field<&T::region_type, enumeration<jaus::region_type, u8>>,
                field<&T::region_buffer, in_units<f32le, metres>>,
                repeated<&T::feature_class, count<"number_of_feature_classes", u8>>,
                presence_flag<&T::feature_class_id_present>,
                presence_flag<&T::feature_class_attribute_present>,
                repeated<&T::region_point, count<"number_of_region_points", u16le>>>>;
    };
};

/// Report Vector Knowledge Store Objects Creation: the names of the objects that a request has created.
/// Code 4A20h, inform class, 3 bytes or more.
struct report_vector_knowledge_store_objects_creation {
    std::uint8_t local_request_id{};       ///< of the request
    wire::list<std::uint32_t> object_id{}; ///< in the request's order; 0: could not be created
    friend constexpr bool operator==(const report_vector_knowledge_store_objects_creation&,
                                     const report_vector_knowledge_store_objects_creation&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4A20;
        using T = report_vector_knowledge_store_objects_creation;
        using type = layout<
            field<&T::local_request_id, u8>,
            repeated<&T::object_id, count<"number_of_objects", u16le>, element<"object", u32le>>>;
    };
};

/// Report Vector Knowledge Store Feature Class Metadata: the text that describes a feature class.
/// Code 4A21h, inform class, 4 bytes or more.
struct report_vector_knowledge_store_feature_class_metadata {
    std::uint16_t feature_class_id{};          ///< the class
    std::string_view feature_class_metadata{}; ///< the text, up to 65535 characters
    friend constexpr bool operator==(const report_vector_knowledge_store_feature_class_metadata&,
                                     const report_vector_knowledge_store_feature_class_metadata&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4A21;
        using query = query_vector_knowledge_store_feature_class_metadata;
        using T = report_vector_knowledge_store_feature_class_metadata;
        using type = layout<
            field<&T::feature_class_id, u16le>,
            string<&T::feature_class_metadata, count<"number_of_string_characters", u16le>>>;
    };
};

/// Report Vector Knowledge Store Bounds: the corners of the area that a feature class covers.
/// Code 4A22h, inform class, 19 bytes.
struct report_vector_knowledge_store_bounds {
    std::uint8_t local_request_id{};  ///< of the request
    std::uint16_t feature_class_id{}; ///< the class
    double southwest_latitude{};      ///< degrees (WGS 84), -90 to 90
    double southwest_longitude{};     ///< degrees (WGS 84), -180 to 180
    double northeast_latitude{};      ///< degrees (WGS 84), -90 to 90
    double northeast_longitude{};     ///< degrees (WGS 84), -180 to 180
    friend constexpr bool operator==(const report_vector_knowledge_store_bounds&,
                                     const report_vector_knowledge_store_bounds&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4A22;
        using query = query_vector_knowledge_store_bounds;
        using T = report_vector_knowledge_store_bounds;
        using type = layout<
            field<&T::local_request_id, u8>,
            field<&T::feature_class_id, u16le>,
            field<&T::southwest_latitude, scaled<i32le, latitude_range>>,
            field<&T::southwest_longitude, scaled<i32le, longitude_range>>,
            field<&T::northeast_latitude, scaled<i32le, latitude_range>>,
            field<&T::northeast_longitude, scaled<i32le, longitude_range>>>;
    };
};

/// Report Vector Knowledge Store Objects: the objects that a query has found.
/// Code 4A23h, inform class, 4 bytes or more. Only presence bit 0 is known, which announces all objects' data; the
/// standard may have finer bits.
struct report_vector_knowledge_store_objects {
    std::uint8_t local_request_id{};                ///< of the query
    std::uint16_t number_of_objects{};              ///< found; sent with or without the objects
    std::optional<wire::list<vks_object>> object{}; ///< the objects found
    friend constexpr bool operator==(const report_vector_knowledge_store_objects&,
                                     const report_vector_knowledge_store_objects&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4A23;
        using query = query_vector_knowledge_store_objects;
        using T = report_vector_knowledge_store_objects;
        using type = layout<
            lenient_presence<u8,
                field<&T::local_request_id, u8>,
                field<&T::number_of_objects, u16le>,
                repeated<&T::object, counted_by<&T::number_of_objects>>>>;
    };
};

/// Report Vector Knowledge Store Data Transfer Termination: the reports are stopped. Code 4A24h, inform class, no body.
struct report_vector_knowledge_store_data_transfer_termination {
    friend constexpr bool operator==(const report_vector_knowledge_store_data_transfer_termination&,
                                     const report_vector_knowledge_store_data_transfer_termination&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4A24;
        using type = layout<>;
    };
};

/// The messages of the subgroup, by command code.
using world_model_subgroup = message_list<
    create_vector_knowledge_store_objects,
    set_vector_knowledge_store_feature_class_metadata,
    terminate_vector_knowledge_store_data_transfer,
    delete_vector_knowledge_store_objects,
    query_vector_knowledge_store_feature_class_metadata,
    query_vector_knowledge_store_bounds,
    query_vector_knowledge_store_objects,
    report_vector_knowledge_store_objects_creation,
    report_vector_knowledge_store_feature_class_metadata,
    report_vector_knowledge_store_bounds,
    report_vector_knowledge_store_objects,
    report_vector_knowledge_store_data_transfer_termination>;

} // namespace jauscat::jaus
