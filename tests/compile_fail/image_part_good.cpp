// expect: no error
#include <jauscat/app.hpp>
#include <jauscat/app/own_table.hpp>
#include <jauscat/schema/translation/wrench_effort_image.hpp>

namespace translation = jauscat::translation;

void use(jauscat::bridge& bridge, const jauscat::slave& slave) {
    using commands = translation::set_wrench_effort_table;
    using reports = translation::report_wrench_effort_table;
    bridge.serve({.component = 33}, slave, jauscat::process_image<commands, reports>());
    bridge.serve({.component = 34}, slave,
                 jauscat::process_image<commands, reports>({.propulsive_linear_effort_x = 0}));
}
