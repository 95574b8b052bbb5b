// PowerPlantManager 1.0, urn:jaus:jss:ugv:PowerPlantManager.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/ranges.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::ugv {

/// Record powerPlantID.
struct power_plant_id_record {
    std::uint8_t power_plant_id{}; ///< 0 to 255
    friend constexpr bool operator==(const power_plant_id_record&, const power_plant_id_record&) = default;

    struct schema : wire::items {
        using T = power_plant_id_record;
        using type = layout<field<&T::power_plant_id, u8>>;
    };
};

/// Values of powerState.
enum class power_state : std::uint8_t {
    power_on = 1,
    power_off = 2,
    power_standby = 3,
};

/// Record gasEngineConfigurationRec.
struct gas_engine_configuration_rec {
    ugv::power_state power_state{};
    std::optional<std::uint16_t> rpm{};
    std::optional<double> throttle{}; ///< 0 to 100
    friend constexpr bool operator==(
        const gas_engine_configuration_rec&,
        const gas_engine_configuration_rec&) = default;

    struct schema : wire::items {
        using T = gas_engine_configuration_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::power_state, in_value_set<enumeration<ugv::power_state, u8>, between<1, 3>>>,
                field<&T::rpm, u16le>,
                field<&T::throttle, scaled<u16le, one_0_to_100>>>>;
    };
};

/// Values of plugState.
enum class plug_state : std::uint8_t {
    glowplug_on = 1,
    glowplug_off = 2,
};

/// Record dieselEngineConfigurationRec.
struct diesel_engine_configuration_rec {
    ugv::power_state power_state{};
    std::optional<std::uint16_t> rpm{};
    std::optional<double> throttle{}; ///< 0 to 100
    std::optional<ugv::plug_state> plug_state{};
    friend constexpr bool operator==(
        const diesel_engine_configuration_rec&,
        const diesel_engine_configuration_rec&) = default;

    struct schema : wire::items {
        using T = diesel_engine_configuration_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::power_state, in_value_set<enumeration<ugv::power_state, u8>, between<1, 3>>>,
                field<&T::rpm, u16le>,
                field<&T::throttle, scaled<u16le, one_0_to_100>>,
                field<&T::plug_state, in_value_set<enumeration<ugv::plug_state, u8>, between<1, 2>>>>>;
    };
};

/// Record batteryConfigurationRec.
struct battery_configuration_rec {
    ugv::power_state power_state{};
    friend constexpr bool operator==(const battery_configuration_rec&, const battery_configuration_rec&) = default;

    struct schema : wire::items {
        using T = battery_configuration_rec;
        using type = layout<field<&T::power_state, in_value_set<enumeration<ugv::power_state, u8>, between<1, 3>>>>;
    };
};

/// Record hydraulicConfigurationRec.
struct hydraulic_configuration_rec {
    ugv::power_state power_state{};
    friend constexpr bool operator==(const hydraulic_configuration_rec&, const hydraulic_configuration_rec&) = default;

    struct schema : wire::items {
        using T = hydraulic_configuration_rec;
        using type = layout<field<&T::power_state, in_value_set<enumeration<ugv::power_state, u8>, between<1, 3>>>>;
    };
};

/// Record fuelCellConfigurationRecs.
struct fuel_cell_configuration_recs {
    ugv::power_state power_state{};
    friend constexpr bool operator==(
        const fuel_cell_configuration_recs&,
        const fuel_cell_configuration_recs&) = default;

    struct schema : wire::items {
        using T = fuel_cell_configuration_recs;
        using type = layout<field<&T::power_state, in_value_set<enumeration<ugv::power_state, u8>, between<1, 3>>>>;
    };
};

/// Sequence powerPlantConfigurationSeq.
struct power_plant_configuration_seq {
    power_plant_id_record power_plant_id{};
    std::variant<
        gas_engine_configuration_rec,
        diesel_engine_configuration_rec,
        battery_configuration_rec,
        hydraulic_configuration_rec,
        fuel_cell_configuration_recs> power_plant_configuration_var{};
    friend constexpr bool operator==(
        const power_plant_configuration_seq&,
        const power_plant_configuration_seq&) = default;

    struct schema : wire::items {
        using T = power_plant_configuration_seq;
        using type = layout<
            nested<&T::power_plant_id>,
            variant<&T::power_plant_configuration_var, u8>>;
    };
};

/// SetPowerPlantConfiguration: ID 0506h, command, input of PowerPlantManager.
struct set_power_plant_configuration {
    wire::list<power_plant_configuration_seq> power_plant_configuration_list{}; ///< up to 255 elements
    friend constexpr bool operator==(
        const set_power_plant_configuration&,
        const set_power_plant_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0506;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_power_plant_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::power_plant_configuration_list, count<"number_of_power_plant_configuration_list", u8>>>;
    };
};

/// QueryPowerPlantConfiguration: ID 2506h, input of PowerPlantManager.
struct query_power_plant_configuration {
    wire::list<power_plant_id_record> id_list{}; ///< up to 255 elements
    friend constexpr bool operator==(
        const query_power_plant_configuration&,
        const query_power_plant_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2506;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_power_plant_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::id_list, count<"number_of_id_list", u8>>>;
    };
};

/// QueryPowerPlantCapabilities: ID 2507h, input of PowerPlantManager.
struct query_power_plant_capabilities {
    wire::list<power_plant_id_record> id_list{}; ///< up to 255 elements
    friend constexpr bool operator==(
        const query_power_plant_capabilities&,
        const query_power_plant_capabilities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2507;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_power_plant_capabilities;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::id_list, count<"number_of_id_list", u8>>>;
    };
};

/// QueryPowerPlantStatus: ID 2508h, input of PowerPlantManager.
struct query_power_plant_status {
    wire::list<power_plant_id_record> id_list{}; ///< up to 255 elements
    friend constexpr bool operator==(const query_power_plant_status&, const query_power_plant_status&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2508;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_power_plant_status;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::id_list, count<"number_of_id_list", u8>>>;
    };
};

/// ReportPowerPlantConfiguration: ID 4506h, output of PowerPlantManager.
struct report_power_plant_configuration {
    wire::list<power_plant_configuration_seq> power_plant_configuration_list{}; ///< up to 255 elements
    friend constexpr bool operator==(
        const report_power_plant_configuration&,
        const report_power_plant_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4506;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_power_plant_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::power_plant_configuration_list, count<"number_of_power_plant_configuration_list", u8>>>;
    };
};

/// Record PowerPlantDescRec.
struct power_plant_desc_rec {
    std::uint8_t power_plant_id{};
    std::string_view description{}; ///< up to 255 characters
    friend constexpr bool operator==(const power_plant_desc_rec&, const power_plant_desc_rec&) = default;

    struct schema : wire::items {
        using T = power_plant_desc_rec;
        using type = layout<
            field<&T::power_plant_id, u8>,
            string<&T::description, count<"description_size", u8>>>;
    };
};

/// Record gasEngineCapabilitiesRec.
struct gas_engine_capabilities_rec {
    std::optional<double> fuel_capacity{};     ///< liter, 0 to 256
    std::optional<double> oil_capacity{};      ///< liter, 0 to 256
    std::optional<double> max_oil_pressure{};  ///< bar, 0 to 512
    std::optional<double> max_oil_temp{};      ///< degree Celsius, -75 to 180
    std::optional<double> max_engine_temp{};   ///< degree Celsius, 0 to 256
    std::optional<double> max_coolant_level{}; ///< liter, 0 to 256
    std::optional<double> max_coolant_temp{};  ///< degree Celsius, -75 to 180
    friend constexpr bool operator==(const gas_engine_capabilities_rec&, const gas_engine_capabilities_rec&) = default;

    struct schema : wire::items {
        using T = gas_engine_capabilities_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::fuel_capacity, scaled<u16le, liter_0_to_256>>,
                field<&T::oil_capacity, scaled<u16le, liter_0_to_256>>,
                field<&T::max_oil_pressure, scaled<u16le, bar_0_to_512>>,
                field<&T::max_oil_temp, scaled<u16le, degree_celsius_minus_75_to_180>>,
                field<&T::max_engine_temp, scaled<u16le, degree_celsius_0_to_256>>,
                field<&T::max_coolant_level, scaled<u16le, liter_0_to_256>>,
                field<&T::max_coolant_temp, scaled<u16le, degree_celsius_minus_75_to_180>>>>;
    };
};

/// Record dieselEngineCapabilitiesRec.
struct diesel_engine_capabilities_rec {
    std::optional<double> fuel_capacity{};      ///< liter, 0 to 256
    std::optional<double> oil_capacity{};       ///< liter, 0 to 256
    std::optional<double> max_oil_pressure{};   ///< bar, 0 to 512
    std::optional<double> max_oil_temp{};       ///< degree Celsius, -75 to 180
    std::optional<double> max_engine_temp{};    ///< degree Celsius, 0 to 256
    std::optional<double> max_coolant_level{};  ///< liter, 0 to 256
    std::optional<double> max_coolant_temp{};   ///< degree Celsius, -75 to 180
    std::optional<double> max_glow_plug_temp{}; ///< degree Celsius, 0 to 256
    std::optional<double> glow_plug_time{};     ///< second, 0 to 256
    friend constexpr bool operator==(
        const diesel_engine_capabilities_rec&,
        const diesel_engine_capabilities_rec&) = default;

    struct schema : wire::items {
        using T = diesel_engine_capabilities_rec;
        using type = layout<
            lenient_presence<u16le,
                field<&T::fuel_capacity, scaled<u16le, liter_0_to_256>>,
                field<&T::oil_capacity, scaled<u16le, liter_0_to_256>>,
                field<&T::max_oil_pressure, scaled<u16le, bar_0_to_512>>,
                field<&T::max_oil_temp, scaled<u16le, degree_celsius_minus_75_to_180>>,
                field<&T::max_engine_temp, scaled<u16le, degree_celsius_0_to_256>>,
                field<&T::max_coolant_level, scaled<u16le, liter_0_to_256>>,
                field<&T::max_coolant_temp, scaled<u16le, degree_celsius_minus_75_to_180>>,
                field<&T::max_glow_plug_temp, scaled<u16le, degree_celsius_0_to_256>>,
                field<&T::glow_plug_time, scaled<u16le, second_0_to_256>>>>;
    };
};

/// Record batteryCapabilitiesRec.
struct battery_capabilities_rec {
    std::optional<double> nominal_voltage{};   ///< volt, 0 to 1000
    std::optional<double> max_charge{};        ///< coulomb, 0 to 3600000
    std::optional<double> max_cranking_amps{}; ///< ampere, 0 to 5000
    friend constexpr bool operator==(const battery_capabilities_rec&, const battery_capabilities_rec&) = default;

    struct schema : wire::items {
        using T = battery_capabilities_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::nominal_voltage, scaled<u16le, volt_0_to_1000>>,
                field<&T::max_charge, scaled<u32le, coulomb_0_to_3600000>>,
                field<&T::max_cranking_amps, scaled<u16le, ampere_0_to_5000>>>>;
    };
};

/// List batteryCapabilitiesList.
struct battery_capabilities_list {
    wire::list<battery_capabilities_rec> elements{}; ///< up to 255 elements
    friend constexpr bool operator==(const battery_capabilities_list&, const battery_capabilities_list&) = default;

    struct schema : wire::items {
        using T = battery_capabilities_list;
        using type = layout<repeated<&T::elements, count<"number_of_elements", u8>>>;
    };
};

/// Record hydraulicCapabilitiesRec.
struct hydraulic_capabilities_rec {
    std::optional<double> fluid_capacity{}; ///< liter, 0 to 256
    std::optional<double> max_pressure{};   ///< bar, 0 to 512
    std::optional<double> max_temp{};       ///< degree Celsius, -75 to 180
    friend constexpr bool operator==(const hydraulic_capabilities_rec&, const hydraulic_capabilities_rec&) = default;

    struct schema : wire::items {
        using T = hydraulic_capabilities_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::fluid_capacity, scaled<u16le, liter_0_to_256>>,
                field<&T::max_pressure, scaled<u16le, bar_0_to_512>>,
                field<&T::max_temp, scaled<u16le, degree_celsius_minus_75_to_180>>>>;
    };
};

/// Record fuelCellCapabilitiesRec.
struct fuel_cell_capabilities_rec {
    std::optional<double> fuel_capacity{}; ///< kilogram, 0 to 256
    friend constexpr bool operator==(const fuel_cell_capabilities_rec&, const fuel_cell_capabilities_rec&) = default;

    struct schema : wire::items {
        using T = fuel_cell_capabilities_rec;
        using type = layout<lenient_presence<u8, field<&T::fuel_capacity, scaled<u16le, kilogram_0_to_256>>>>;
    };
};

/// Sequence powerPlantCapabilitiesSeq.
struct power_plant_capabilities_seq {
    ugv::power_plant_desc_rec power_plant_desc_rec{};
    std::variant<
        gas_engine_capabilities_rec,
        diesel_engine_capabilities_rec,
        battery_capabilities_list,
        hydraulic_capabilities_rec,
        fuel_cell_capabilities_rec> power_plant_capabilities_var{};
    friend constexpr bool operator==(
        const power_plant_capabilities_seq&,
        const power_plant_capabilities_seq&) = default;

    struct schema : wire::items {
        using T = power_plant_capabilities_seq;
        using type = layout<
            nested<&T::power_plant_desc_rec>,
            variant<&T::power_plant_capabilities_var, u8>>;
    };
};

/// ReportPowerPlantCapabilities: ID 4507h, output of PowerPlantManager.
struct report_power_plant_capabilities {
    wire::list<power_plant_capabilities_seq> power_plant_capabilities_list{}; ///< up to 255 elements
    friend constexpr bool operator==(
        const report_power_plant_capabilities&,
        const report_power_plant_capabilities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4507;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_power_plant_capabilities;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::power_plant_capabilities_list, count<"number_of_power_plant_capabilities_list", u8>>>;
    };
};

/// Record gasEngineStatus.
struct gas_engine_status {
    std::optional<double> percent_remaining_fuel{}; ///< 0 to 100
    std::optional<double> percent_oil_pressure{};   ///< 0 to 200
    std::optional<double> percent_oil_level{};      ///< 0 to 100
    std::optional<double> oil_temp{};               ///< degree Celsius, -75 to 180
    std::optional<double> engine_temp{};            ///< degree Celsius, -75 to 180
    std::optional<std::uint32_t> engine_hours{};    ///< hour
    std::optional<std::uint16_t> tachometer{};
    std::optional<double> coolant_level{};          ///< liter, 0 to 256
    std::optional<double> coolant_temp{};           ///< degree Celsius, -75 to 180
    std::optional<double> air_intake_pressure{};    ///< bar, 0 to 512
    std::optional<double> air_intake_temp{};        ///< degree Celsius, -75 to 180
    std::optional<double> exhaust_temp{};           ///< degree Celsius, -75 to 180
    friend constexpr bool operator==(const gas_engine_status&, const gas_engine_status&) = default;

    struct schema : wire::items {
        using T = gas_engine_status;
        using type = layout<
            lenient_presence<u16le,
                field<&T::percent_remaining_fuel, scaled<u16le, one_0_to_100>>,
                field<&T::percent_oil_pressure, scaled<u16le, one_0_to_200>>,
                field<&T::percent_oil_level, scaled<u16le, one_0_to_100>>,
                field<&T::oil_temp, scaled<u16le, degree_celsius_minus_75_to_180>>,
                field<&T::engine_temp, scaled<u16le, degree_celsius_minus_75_to_180>>,
                field<&T::engine_hours, in_units<u32le, hour>>,
                field<&T::tachometer, u16le>,
                field<&T::coolant_level, scaled<u16le, liter_0_to_256>>,
                field<&T::coolant_temp, scaled<u16le, degree_celsius_minus_75_to_180>>,
                field<&T::air_intake_pressure, scaled<u16le, bar_0_to_512>>,
                field<&T::air_intake_temp, scaled<u16le, degree_celsius_minus_75_to_180>>,
                field<&T::exhaust_temp, scaled<u16le, degree_celsius_minus_75_to_180>>>>;
    };
};

/// Record dieselEngineStatus.
struct diesel_engine_status {
    std::optional<double> percent_remaining_fuel{}; ///< 0 to 100
    std::optional<double> percent_oil_pressure{};   ///< 0 to 200
    std::optional<double> percent_oil_level{};      ///< 0 to 100
    std::optional<double> oil_temp{};               ///< degree Celsius, -75 to 180
    std::optional<double> engine_temp{};            ///< degree Celsius, -75 to 180
    std::optional<std::uint32_t> engine_hours{};    ///< hour
    std::optional<std::uint16_t> tachometer{};
    std::optional<double> coolant_level{};          ///< liter, 0 to 256
    std::optional<double> coolant_temp{};           ///< degree Celsius, -75 to 180
    std::optional<double> air_intake_pressure{};    ///< bar, 0 to 512
    std::optional<double> air_intake_temp{};        ///< degree Celsius, -75 to 180
    std::optional<double> exhaust_temp{};           ///< degree Celsius, -75 to 180
    std::optional<double> glow_plug_temp{};         ///< degree Celsius, -75 to 180
    friend constexpr bool operator==(const diesel_engine_status&, const diesel_engine_status&) = default;

    struct schema : wire::items {
        using T = diesel_engine_status;
        using type = layout<
            lenient_presence<u16le,
                field<&T::percent_remaining_fuel, scaled<u8, one_0_to_100>>,
                field<&T::percent_oil_pressure, scaled<u8, one_0_to_200>>,
                field<&T::percent_oil_level, scaled<u16le, one_0_to_100>>,
                field<&T::oil_temp, scaled<u16le, degree_celsius_minus_75_to_180>>,
                field<&T::engine_temp, scaled<u16le, degree_celsius_minus_75_to_180>>,
                field<&T::engine_hours, in_units<u32le, hour>>,
                field<&T::tachometer, u16le>,
                field<&T::coolant_level, scaled<u16le, liter_0_to_256>>,
                field<&T::coolant_temp, scaled<u16le, degree_celsius_minus_75_to_180>>,
                field<&T::air_intake_pressure, scaled<u16le, bar_0_to_512>>,
                field<&T::air_intake_temp, scaled<u16le, degree_celsius_minus_75_to_180>>,
                field<&T::exhaust_temp, scaled<u16le, degree_celsius_minus_75_to_180>>,
                field<&T::glow_plug_temp, scaled<u16le, degree_celsius_minus_75_to_180>>>>;
    };
};

/// Record batteryStatusRec.
struct battery_status_rec {
    std::optional<double> percent_charge_remaining{}; ///< 0 to 100
    std::optional<double> voltage{};                  ///< volt, 0 to 1000
    std::optional<double> current_draw{};             ///< ampere, 0 to 1000
    std::optional<double> battery_temp{};             ///< degree Celsius, -75 to 180
    std::optional<std::uint32_t> battery_hours{};     ///< hour
    friend constexpr bool operator==(const battery_status_rec&, const battery_status_rec&) = default;

    struct schema : wire::items {
        using T = battery_status_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::percent_charge_remaining, scaled<u16le, one_0_to_100>>,
                field<&T::voltage, scaled<u16le, volt_0_to_1000>>,
                field<&T::current_draw, scaled<u16le, ampere_0_to_1000>>,
                field<&T::battery_temp, scaled<u16le, degree_celsius_minus_75_to_180>>,
                field<&T::battery_hours, in_units<u32le, hour>>>>;
    };
};

/// List batteryStatus.
struct battery_status {
    wire::list<battery_status_rec> elements{}; ///< up to 255 elements
    friend constexpr bool operator==(const battery_status&, const battery_status&) = default;

    struct schema : wire::items {
        using T = battery_status;
        using type = layout<repeated<&T::elements, count<"number_of_elements", u8>>>;
    };
};

/// Record hydraulicStatus.
struct hydraulic_status {
    std::optional<double> fluid_level{};            ///< liter, 0 to 256
    std::optional<double> percent_fluid_pressure{}; ///< 0 to 200
    std::optional<double> fluid_temp{};             ///< degree Celsius, -75 to 180
    std::optional<std::uint32_t> total_hours{};     ///< hour
    friend constexpr bool operator==(const hydraulic_status&, const hydraulic_status&) = default;

    struct schema : wire::items {
        using T = hydraulic_status;
        using type = layout<
            lenient_presence<u8,
                field<&T::fluid_level, scaled<u16le, liter_0_to_256>>,
                field<&T::percent_fluid_pressure, scaled<u16le, one_0_to_200>>,
                field<&T::fluid_temp, scaled<u16le, degree_celsius_minus_75_to_180>>,
                field<&T::total_hours, in_units<u32le, hour>>>>;
    };
};

/// Record fuelCellStatus.
struct fuel_cell_status {
    std::optional<double> percent_remaining_fuel{}; ///< 0 to 100
    std::optional<std::uint32_t> total_hours{};     ///< hour
    friend constexpr bool operator==(const fuel_cell_status&, const fuel_cell_status&) = default;

    struct schema : wire::items {
        using T = fuel_cell_status;
        using type = layout<
            lenient_presence<u8,
                field<&T::percent_remaining_fuel, scaled<u16le, one_0_to_100>>,
                field<&T::total_hours, in_units<u32le, hour>>>>;
    };
};

/// Sequence powerPlantStatus.
struct power_plant_status {
    ugv::power_plant_desc_rec power_plant_desc_rec{};
    std::variant<
        gas_engine_status,
        diesel_engine_status,
        battery_status,
        hydraulic_status,
        fuel_cell_status> power_plant_status_var{};
    friend constexpr bool operator==(const power_plant_status&, const power_plant_status&) = default;

    struct schema : wire::items {
        using T = power_plant_status;
        using type = layout<
            nested<&T::power_plant_desc_rec>,
            variant<&T::power_plant_status_var, u8>>;
    };
};

/// ReportPowerPlantStatus: ID 4508h, output of PowerPlantManager.
struct report_power_plant_status {
    wire::list<power_plant_status> power_plant_status_list{}; ///< up to 255 elements
    friend constexpr bool operator==(const report_power_plant_status&, const report_power_plant_status&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4508;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_power_plant_status;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::power_plant_status_list, count<"number_of_power_plant_status_list", u8>>>;
    };
};

namespace services {

/// PowerPlantManager: what it is called, and its messages.
struct power_plant_manager {
    static constexpr std::string_view name = "PowerPlantManager";
    static constexpr std::string_view uri = "urn:jaus:jss:ugv:PowerPlantManager";
    static constexpr std::string_view version = "1.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:AccessControl";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        set_power_plant_configuration,
        query_power_plant_configuration,
        query_power_plant_capabilities,
        query_power_plant_status>;
    using outputs = jaus::message_list<
        report_power_plant_configuration,
        report_power_plant_capabilities,
        report_power_plant_status>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::ugv
