// The options --web, --web-token and --web-page: the live view of a program. With JAUSCAT_BUILD_LIVE=OFF a program has
// none.
#pragma once
#include "support/program.hpp"
#include "support/say.hpp"
#include <jauscat/net/live/live_server.hpp>
#include <jauscat/version.hpp>

#include <charconv>
#include <cstdint>
#include <deque>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace example {

#ifdef JAUSCAT_HAS_LIVE_VIEW
inline void add_web_options(boost::program_options::options_description& options) {
    namespace po = boost::program_options;
    // clang-format off
    options.add_options()
        ("web", po::value<std::string>(), "[ADDRESS:]PORT of the live view for a browser, of this machine alone unless ADDRESS is another one than 127.0.0.1; port 0: any (docs/live.md)")
        ("web-token", po::value<std::string>(), "what a viewer must give, 8 to 128 letters, digits, - and _; by default a random one where ADDRESS is not of this machine alone")
        ("web-page", po::value<std::string>(), "HTML file to serve instead of the page that is built in: build/web/jauscat.html also makes messages");
    // clang-format on
}

/// Address and port of --web.
inline std::pair<std::string, std::uint16_t> web_endpoint(const std::string& text) {
    const auto colon = text.rfind(':');
    std::string address = colon == text.npos ? "127.0.0.1" : text.substr(0, colon);
    const auto digits = std::string_view{text}.substr(colon == text.npos ? 0 : colon + 1);
    if (address.starts_with('[') && address.ends_with(']')) address = address.substr(1, address.size() - 2);
    std::uint16_t port{};
    const auto* const end = digits.data() + digits.size();
    const auto read = std::from_chars(digits.data(), end, port);
    if (address.empty() || read.ec != std::errc{} || read.ptr != end)
        throw usage_error{"--web must be PORT or ADDRESS:PORT, such as 8080 or 192.168.1.2:8080, not '" + text + "'"};
    return {std::move(address), port};
}

/// Without --web it does nothing.
class live_view {
  public:
    /// Opens the port. `name`: of the program's system.
    live_view(std::string program, const boost::program_options::variables_map& values, const std::string& name,
              const jauscat::catalogue::list& messages, const jauscat::catalogue::list* sae_messages = nullptr)
        : program_{std::move(program)} {
        const auto text = [&](const char* option) {
            return values.count(option) != 0 ? values[option].as<std::string>() : std::string{};
        };
        if (values.count("web") == 0) {
            for (const std::string option : {"web-token", "web-page"})
                if (values.count(option) != 0) throw usage_error{"--" + option + " needs --web"};
            return;
        }
        auto [address, port] = web_endpoint(text("web"));
        try {
            server_.emplace(jauscat::net::live_options{.address = std::move(address),
                                                       .port = port,
                                                       .token = text("web-token"),
                                                       .page_file = text("web-page"),
                                                       .program = program_,
                                                       .version = JAUSCAT_VERSION_TEXT,
                                                       .name = name,
                                                       .messages = &messages,
                                                       .sae_messages = sae_messages});
        } catch (const std::invalid_argument& error) {
            throw usage_error{error.what()};
        }
        on_fault() = [this](bool is_bad, const std::string& line) {
            server_->fault(is_bad ? jauscat::net::live_level::bad : jauscat::net::live_level::warning, line);
        };
    }
    ~live_view() { on_fault() = nullptr; }
    live_view(const live_view&) = delete;
    live_view& operator=(const live_view&) = delete;

    /// For the messages of one thread; nullptr without --web.
    [[nodiscard]] jauscat::net::live_feed* make_feed() {
        if (!server_) return nullptr;
        server_->add(feeds_.emplace_back());
        return &feeds_.back();
    }
    /// After all feeds are made, and after the program has given up its privileges.
    void start() {
        if (server_) server_->start();
    }
    /// The page's address; empty without --web.
    [[nodiscard]] std::string link() const { return server_ ? server_->link() : std::string{}; }
    /// Logs it.
    void tell() const {
        if (!server_) return;
        write_event(events::web_opened, {{"link", server_->link()}},
                    program_ + ": live view at " + server_->link() + "\n");
    }

  private:
    std::string program_;
    std::deque<jauscat::net::live_feed> feeds_{};
    std::optional<jauscat::net::live_server> server_{};
};
#else
inline void add_web_options(boost::program_options::options_description&) {}

class live_view {
  public:
    live_view(const std::string&, const boost::program_options::variables_map&, const std::string&,
              const jauscat::catalogue::list&, const jauscat::catalogue::list* = nullptr) {}
    [[nodiscard]] static jauscat::net::live_feed* make_feed() { return nullptr; }
    static void start() {}
    [[nodiscard]] static std::string link() { return {}; }
    static void tell() {}
};
#endif

} // namespace example
