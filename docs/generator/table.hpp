// Tables and headings in GitHub's Markdown.
#pragma once
#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace jauscat::reference {

inline std::string code(std::string_view text) { return "`" + std::string{text} + "`"; }

/// Rows of text; columns without any are left out.
class table {
  public:
    explicit table(std::vector<std::string> heads) : heads_{std::move(heads)} {}
    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
    [[nodiscard]] std::string text() const {
        std::string made = line(heads_);
        made += line(std::vector<std::string>(heads_.size(), "---"));
        for (const auto& row : rows_) made += line(row);
        return made;
    }

  private:
    [[nodiscard]] std::string line(const std::vector<std::string>& row) const {
        std::string made = "|";
        for (std::size_t i = 0; i != row.size(); ++i)
            if (std::ranges::any_of(rows_, [&](const auto& other) { return !other[i].empty(); }))
                made += " " + row[i] + (row[i].empty() ? "|" : " |");
        return made + "\n";
    }
    std::vector<std::string> heads_;
    std::vector<std::vector<std::string>> rows_{};
};

/// GitHub's anchor of a heading.
inline std::string anchor(std::string_view heading) {
    std::string made;
    for (const char c : heading) {
        if (c == ' ') made += '-';
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_')
            made += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return made;
}

} // namespace jauscat::reference
