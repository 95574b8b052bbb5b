// expect: image_part: the second table is an image_table of a report that answers a query, for the inputs
#include <jauscat/app.hpp>
#include <jauscat/app/own_table.hpp>
#include <jauscat/schema/translation/wrench_effort_image.hpp>

namespace translation = jauscat::translation;

void use(jauscat::bridge& bridge, const jauscat::slave& slave) {
    using commands = translation::set_wrench_effort_table;
    bridge.serve({.component = 33}, slave, jauscat::process_image<commands, commands>());
}
