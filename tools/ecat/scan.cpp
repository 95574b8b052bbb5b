// scan: one row a slave.
#include "ecat/arguments.hpp"
#include "ecat/sii.hpp"
#include "ecat/value.hpp"

namespace ecat {

int scan(const arguments& given) {
    ring on{given.link};
    on.guard();
    std::vector<record> rows;
    bool is_complete = true;
    {
        progress_line progress;
        for (std::uint16_t i = 0; i != on.slaves(); ++i) {
            progress.show("slave " + std::to_string(i + 1) + " of " + std::to_string(on.slaves()));
            const auto& is = on.states()[i];
            sii_content sii;
            try {
                sii_reader reader{on, i};
                sii = read_sii(reader, sii_depth::name);
            } catch (const failure& error) {
                if (stop_requested() || error.code() == bus_in_use) throw;
                note(error.what());
                is_complete = false;
            }
            rows.push_back({{"position", i},
                            {"station", is.station},
                            {"alias", is.alias},
                            {"vendor", hex_value(sii.identity.vendor, 8)},
                            {"product", hex_value(sii.identity.product, 8)},
                            {"revision", hex_value(sii.identity.revision, 8)},
                            {"serial", sii.identity.serial},
                            {"name", sii.name()},
                            {"state", state_text(is.al)}});
        }
    }
    if (given.is_json)
        print_json(list{rows.begin(), rows.end()});
    else
        print_table(rows);
    return is_complete ? success : failed;
}

} // namespace ecat
