// Reads ESI files: their devices and modules, objects resolved through the file's data types.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/esi/device.hpp>
#include <jauscat/esi/error.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace jauscat::esi {

namespace detail {
class esi_reader;
}

inline namespace JAUSCAT_WAY {

/// Which device of a file with several. A part that is not given is not compared.
struct device_choice {
    std::optional<std::uint32_t> product{};
    std::optional<std::uint32_t> revision{}; ///< where no device has it: the newest one below
    std::optional<std::size_t> number{};     ///< in the order of the file, from 0
};

/// A device as a list shows it.
struct device_summary {
    std::uint32_t product_code{}; ///< 0: not stated, or no number
    std::uint32_t revision{};     ///< 0: not stated, or no number
    std::string type{};           ///< short name, such as an order number
    std::string name{};           ///< for display
    std::size_t line{};           ///< of the file, from 1
};

/// An ESI document, parsed once. Copies share it.
///
///     const auto file = esi::esi_file::open("terminals.xml");
///     if (!file) return std::cerr << describe(file.error()) << '\n', 1;
///     for (const auto& each : file->devices()) std::cout << each.type << '\n';
///     const auto device = file->read({.product = 0x03EC3052});
class esi_file {
  public:
    /// Without a device.
    esi_file() = default;
    /// Errors: unreadable, and those of `parse`.
    [[nodiscard]] JAUSCAT_DECL static result<esi_file, error> open(const std::filesystem::path& path);
    /// `source` is the file's name in messages. Errors: not_xml, not_esi.
    [[nodiscard]] JAUSCAT_DECL static result<esi_file, error> parse(std::string_view text, std::string source);

    /// All of them, in the order of the file.
    [[nodiscard]] const std::vector<device_summary>& devices() const noexcept { return devices_; }
    /// Reads the device that fits the choice. Without a choice, the document has one device. An element that is left
    /// out has no value. What a slip of the file costs, an object or a PDO, is in `device::slips`.
    [[nodiscard]] JAUSCAT_DECL result<device, error> read(const device_choice& choice = {}) const;
    /// Reads all modules.
    [[nodiscard]] JAUSCAT_DECL std::vector<module_description> modules() const;

  private:
    JAUSCAT_DECL explicit esi_file(std::shared_ptr<const detail::esi_reader> reader);

    std::shared_ptr<const detail::esi_reader> reader_{};
    std::vector<device_summary> devices_{};
};

/// `esi_file::parse` and `read`.
[[nodiscard]] JAUSCAT_DECL result<device, error> parse_esi(std::string_view text, std::string source,
                                                           const device_choice& choice = {});

/// `esi_file::open` and `read`.
[[nodiscard]] JAUSCAT_DECL result<device, error> read_esi(const std::filesystem::path& path,
                                                          const device_choice& choice = {});

} // namespace JAUSCAT_WAY
} // namespace jauscat::esi

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/esi/impl/read_esi.ipp>
#endif
