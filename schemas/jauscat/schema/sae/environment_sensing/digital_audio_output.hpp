// DigitalAudioOutput 2.0, urn:jaus:jss:environmentSensing:DigitalAudioOutput.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/environment_sensing/shared.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::environment_sensing {

/// Record RequestIdRec.
struct digital_audio_output_request_id_rec {
    std::uint8_t request_id{};
    friend constexpr bool operator==(
        const digital_audio_output_request_id_rec&,
        const digital_audio_output_request_id_rec&) = default;

    struct schema : wire::items {
        using T = digital_audio_output_request_id_rec;
        using type = layout<field<&T::request_id, u8>>;
    };
};

/// Values of Repeat.
enum class repeat : std::uint8_t {
    play_once = 0,
    repeat_until_new_stream_specified = 1,
};

/// Record DigitalAudioOutputSourceRec.
struct digital_audio_output_source_rec {
    std::uint16_t sensor_id{};     ///< 1 to 65535
    std::string_view stream_url{}; ///< up to 255 characters
    environment_sensing::repeat repeat{};
    double volume{};               ///< percent, 0 to 100
    friend constexpr bool operator==(
        const digital_audio_output_source_rec&,
        const digital_audio_output_source_rec&) = default;

    struct schema : wire::items {
        using T = digital_audio_output_source_rec;
        using type = layout<
            field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
            string<&T::stream_url, count<"stream_url_size", u8>>,
            field<&T::repeat, in_value_set<enumeration<environment_sensing::repeat, u8>, between<0, 1>>>,
            field<&T::volume, scaled<u16le, percent_0_to_100>>>;
    };
};

/// SetDigitalAudioOutputSource: ID 0818h, command, input of DigitalAudioOutput.
struct set_digital_audio_output_source {
    digital_audio_output_request_id_rec request_id_rec{};
    wire::list<digital_audio_output_source_rec> digital_audio_output_source_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const set_digital_audio_output_source&,
        const set_digital_audio_output_source&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0818;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_digital_audio_output_source;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            nested<&T::request_id_rec>,
            repeated<&T::digital_audio_output_source_list, count<"number_of_digital_audio_output_source_list", u16le>>>;
    };
};

/// QueryDigitalAudioOutputSource: ID 2818h, input of DigitalAudioOutput.
struct query_digital_audio_output_source {
    environment_sensing::sensor_id sensor_id{}; ///< 1 to 65535
    friend constexpr bool operator==(
        const query_digital_audio_output_source&,
        const query_digital_audio_output_source&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2818;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_digital_audio_output_source;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::sensor_id, enumeration<environment_sensing::sensor_id, u16le>>>;
    };
};

/// QueryDigitalAudioOutputCapabilities: ID 2819h, input of DigitalAudioOutput.
struct query_digital_audio_output_capabilities {
    environment_sensing::sensor_id sensor_id{}; ///< 1 to 65535
    friend constexpr bool operator==(
        const query_digital_audio_output_capabilities&,
        const query_digital_audio_output_capabilities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2819;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_digital_audio_output_capabilities;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::sensor_id, enumeration<environment_sensing::sensor_id, u16le>>>;
    };
};

/// ReportDigitalAudioOutputSource: ID 4818h, output of DigitalAudioOutput.
struct report_digital_audio_output_source {
    wire::list<digital_audio_output_source_rec> digital_audio_output_source_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const report_digital_audio_output_source&,
        const report_digital_audio_output_source&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4818;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_digital_audio_output_source;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::digital_audio_output_source_list, count<"number_of_digital_audio_output_source_list", u16le>>>;
    };
};

/// Values of LPCM_PCM.
enum class lpcm_pcm : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of AIFF.
enum class aiff : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of WAV.
enum class wav : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of ALAC.
enum class alac : std::uint8_t {
    supported = 1,
    not_supported = 0,
};

/// Values of FLAC.
enum class flac : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of RealAudio.
enum class real_audio : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of WMA9_Lossless.
enum class wma9_lossless : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of TrueAudio.
enum class true_audio : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of DolbyDigital.
enum class dolby_digital : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of DTS.
enum class dts : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of MP2.
enum class mp2 : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of MP3.
enum class mp3 : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of AAC_MPEG2.
enum class aac_mpeg2 : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of AAC_MPEG4.
enum class aac_mpeg4 : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of VORBIS.
enum class vorbis : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of WMA.
enum class wma : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of Speex.
enum class speex : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Bits of SupportedDigitalFormats.
struct digital_audio_output_supported_digital_formats {
    environment_sensing::lpcm_pcm lpcm_pcm{};
    environment_sensing::aiff aiff{};
    environment_sensing::wav wav{};
    environment_sensing::alac alac{};
    environment_sensing::flac flac{};
    environment_sensing::real_audio real_audio{};
    environment_sensing::wma9_lossless wma9_lossless{};
    environment_sensing::true_audio true_audio{};
    environment_sensing::dolby_digital dolby_digital{};
    environment_sensing::dts dts{};
    environment_sensing::mp2 mp2{};
    environment_sensing::mp3 mp3{};
    environment_sensing::aac_mpeg2 aac_mpeg2{};
    environment_sensing::aac_mpeg4 aac_mpeg4{};
    environment_sensing::vorbis vorbis{};
    environment_sensing::wma wma{};
    environment_sensing::speex speex{};
    friend constexpr bool operator==(
        const digital_audio_output_supported_digital_formats&,
        const digital_audio_output_supported_digital_formats&) = default;

    struct schema : wire::items {
        using T = digital_audio_output_supported_digital_formats;
        using type = layout<
            bit_fields<u32le,
                bit_field<&T::lpcm_pcm, 1>,
                bit_field<&T::aiff, 1>,
                bit_field<&T::wav, 1>,
                bit_field<&T::alac, 1>,
                bit_field<&T::flac, 1>,
                bit_field<&T::real_audio, 1>,
                bit_field<&T::wma9_lossless, 1>,
                bit_field<&T::true_audio, 1>,
                bit_field<&T::dolby_digital, 1>,
                bit_field<&T::dts, 1>,
                bit_field<&T::mp2, 1>,
                bit_field<&T::mp3, 1>,
                bit_field<&T::aac_mpeg2, 1>,
                bit_field<&T::aac_mpeg4, 1>,
                bit_field<&T::vorbis, 1>,
                bit_field<&T::wma, 1>,
                bit_field<&T::speex, 1>,
                reserved<15>>>;
    };
};

/// Values of EIGHT_BITS.
enum class eight_bits : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of TEN_BITS.
enum class ten_bits : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of TWELVE_BITS.
enum class twelve_bits : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of FOURTEEN_BITS.
enum class fourteen_bits : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of SIXTEEN_BITS.
enum class sixteen_bits : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of TWENTY_BITS.
enum class twenty_bits : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of TWENTY_FOUR_BITS.
enum class twenty_four_bits : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of THIRTY_TWO_BITS.
enum class thirty_two_bits : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Bits of SupportedBitDepths.
struct supported_bit_depths {
    environment_sensing::eight_bits eight_bits{};
    environment_sensing::ten_bits ten_bits{};
    environment_sensing::twelve_bits twelve_bits{};
    environment_sensing::fourteen_bits fourteen_bits{};
    environment_sensing::sixteen_bits sixteen_bits{};
    environment_sensing::twenty_bits twenty_bits{};
    environment_sensing::twenty_four_bits twenty_four_bits{};
    environment_sensing::thirty_two_bits thirty_two_bits{};
    friend constexpr bool operator==(const supported_bit_depths&, const supported_bit_depths&) = default;

    struct schema : wire::items {
        using T = supported_bit_depths;
        using type = layout<
            bit_fields<u16le,
                bit_field<&T::eight_bits, 1>,
                bit_field<&T::ten_bits, 1>,
                bit_field<&T::twelve_bits, 1>,
                bit_field<&T::fourteen_bits, 1>,
                bit_field<&T::sixteen_bits, 1>,
                bit_field<&T::twenty_bits, 1>,
                bit_field<&T::twenty_four_bits, 1>,
                bit_field<&T::thirty_two_bits, 1>,
                reserved<8>>>;
    };
};

/// Record DigitalAudioOutputCapabilitiesRec.
struct digital_audio_output_capabilities_rec {
    std::uint16_t sensor_id{}; ///< 1 to 65535
    std::optional<std::uint16_t> minimum_allowed_bit_rate{};
    std::optional<std::uint16_t> maximum_allowed_bit_rate{};
    std::optional<digital_audio_output_supported_digital_formats> supported_digital_formats{};
    std::optional<std::uint32_t> min_sample_rate{};
    std::optional<std::uint32_t> max_sample_rate{};
    std::optional<environment_sensing::supported_bit_depths> supported_bit_depths{};
    friend constexpr bool operator==(
        const digital_audio_output_capabilities_rec&,
        const digital_audio_output_capabilities_rec&) = default;

    struct schema : wire::items {
        using T = digital_audio_output_capabilities_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
                field<&T::minimum_allowed_bit_rate, u16le>,
                field<&T::maximum_allowed_bit_rate, u16le>,
                nested<&T::supported_digital_formats>,
                field<&T::min_sample_rate, u32le>,
                field<&T::max_sample_rate, u32le>,
                nested<&T::supported_bit_depths>>>;
    };
};

/// ReportDigitalAudioOutputCapabilities: ID 4819h, output of DigitalAudioOutput.
struct report_digital_audio_output_capabilities {
    /// up to 65535 elements
    wire::list<digital_audio_output_capabilities_rec> digital_audio_output_capabilities_list{};
    friend constexpr bool operator==(
        const report_digital_audio_output_capabilities&,
        const report_digital_audio_output_capabilities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4819;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_digital_audio_output_capabilities;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::digital_audio_output_capabilities_list,
                count<"number_of_digital_audio_output_capabilities_list", u16le>>>;
    };
};

namespace services {

/// DigitalAudioOutput: what it is called, and its messages.
struct digital_audio_output {
    static constexpr std::string_view name = "DigitalAudioOutput";
    static constexpr std::string_view uri = "urn:jaus:jss:environmentSensing:DigitalAudioOutput";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:AccessControl";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        set_digital_audio_output_source,
        query_digital_audio_output_source,
        query_digital_audio_output_capabilities>;
    using outputs = jaus::message_list<
        confirm_sensor_configuration,
        report_digital_audio_output_source,
        report_digital_audio_output_capabilities>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::environment_sensing
