// The live view: a web server that shows what passes a program. Link jauscat::live; docs/live.md is the manual.
#pragma once
#include <jauscat/catalogue/list.hpp>
#include <jauscat/net/live/live_feed.hpp>
#include <jauscat/net/open_error.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace jauscat::net {

/// All options but the program's name have defaults.
struct live_options {
    std::string address{"127.0.0.1"}; ///< IP address to listen on; "localhost" is 127.0.0.1
    std::uint16_t port{};             ///< 0: any that is free
    /// That a viewer must give, 8 to 128 letters, digits, '-' and '_'. Empty: none on a loopback address, a random one
    /// on others.
    std::string token{};
    std::string page_file{};               ///< HTML file to serve; empty: the page that is built in
    std::string program{};                 ///< name of the program
    std::string version{};                 ///< of the program
    std::string name{};                    ///< of the program's system; empty: none
    const catalogue::list* messages{};     ///< of the RA, to be decoded; nullptr: none
    const catalogue::list* sae_messages{}; ///< of SAE JAUS
    int send_buffer{};                     ///< bytes of a viewer's socket that wait to be sent; 0: 256 KiB
};

enum class live_level : std::uint8_t { info, warning, bad };

/// Counts since the start.
struct live_counts {
    std::size_t viewers{};   ///< now
    std::uint64_t lost{};    ///< messages that were not shown
    std::uint64_t skipped{}; ///< updates that viewers were too slow for
    std::uint64_t updates{}; ///< that were sent
    std::uint64_t refused{}; ///< requests
};

/// Serves a page and, to up to 8 viewers, updates every 100 ms. It works in a thread of its own with low priority, and
/// takes nothing from a viewer but the request for the page.
///
///     net::live_feed feed;
///     net::live_server server{{.port = 8080, .program = "robot", .messages = &catalogue::ra_3_3()}};
///     server.add(feed);
///     server.start();
class live_server {
  public:
    static constexpr std::size_t max_viewers = 8;
    static constexpr std::size_t max_rows = 1000; ///< kinds of messages that are shown
    static constexpr std::size_t max_faults = 200;

    /// Opens the port. Throws `open_error`, and `std::invalid_argument` for a wrong token or a page that cannot be
    /// read.
    explicit live_server(live_options options);
    ~live_server();
    live_server(const live_server&) = delete;
    live_server& operator=(const live_server&) = delete;

    /// Before `start`; the feed must outlive the server.
    void add(live_feed& feed);
    /// Starts the thread.
    void start();

    /// The page's address, with the token: `http://127.0.0.1:8080/?token=...`.
    [[nodiscard]] const std::string& link() const noexcept;
    [[nodiscard]] std::uint16_t port() const noexcept;
    /// A line of the program's log. The last 200 are kept. From any thread.
    void fault(live_level level, std::string_view line);
    /// From any thread.
    [[nodiscard]] live_counts counts() const;

  private:
    class worker;
    std::unique_ptr<worker> worker_;
};

} // namespace jauscat::net
