// The comments of the schemas' headers: the meaning of structures, members and enumerators, which no template can see.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace jauscat::reference {

/// The parts of the comment above a message.
struct message_remark {
    std::string meaning{}; ///< a sentence, or empty
    std::string notes{};   ///< further sentences
};

/// Of a service that has a message.
struct service_remark {
    std::string name{}; ///< Management
    bool is_input{};    ///< of the service, else output
};
/// The comment above a message of SAE JAUS.
struct sae_remark {
    std::string name{};                     ///< ReportStatus
    std::string role{};                     ///< command, deprecated, input of ..., output of ...
    std::vector<service_remark> services{}; ///< of the role
};

class remarks {
  public:
    /// Reads every header of `folder`. Throws std::runtime_error when there is none.
    explicit remarks(const std::filesystem::path& folder);

    /// First sentence of a header: `platform` has "Platform subgroup of RA 3.3 part 3: ..."
    [[nodiscard]] const std::string& of_header(const std::string& stem) const { return found(headers_, stem); }
    /// The header that defines a structure, without folder and ending.
    [[nodiscard]] const std::string& header_of(const std::string& structure) const { return found(homes_, structure); }
    /// The comment above a structure or enumeration, or empty.
    [[nodiscard]] const std::string& of_type(const std::string& type) const { return found(types_, type); }
    /// The comment behind a member or enumerator, or empty.
    [[nodiscard]] const std::string& of_member(const std::string& type, const std::string& member) const;

    /// The comment above a message, or empty parts. Throws if it does not have the standard's name and the code.
    [[nodiscard]] message_remark of_message(const std::string& type, std::string_view name,
                                            std::string_view code) const;
    /// Throws if the comment is not that of a message with the code.
    [[nodiscard]] sae_remark of_sae_message(const std::string& type, std::string_view code) const;

  private:
    using texts = std::map<std::string, std::string>;
    void read(const std::filesystem::path& header);
    static const std::string& found(const texts& among, const std::string& key);

    texts headers_{}, homes_{}, types_{};
    std::map<std::string, texts> members_{}; // by type
};

} // namespace jauscat::reference
