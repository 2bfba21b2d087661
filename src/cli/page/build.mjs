// Makes the page's template, one HTML file with everything in it, as a C++ source: node build.mjs OUT
// Run where node_modules has three and esbuild.

import {createHash} from 'node:crypto';
import {readFileSync, writeFileSync} from 'node:fs';

import {build} from 'esbuild';

const bundled = async (entry, format) => {
  const result = await build({
    entryPoints: [entry], bundle: true, minify: true, format, target: 'es2022', charset: 'utf8', legalComments: 'none', write: false, logLevel: 'warning',
  });
  return result.outputFiles[0].text;
};

const escaped = text => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');
const hash = text => 'sha256-' + createHash('sha256').update(text).digest('base64');

const script = await bundled('main.js', 'iife');
const style = await bundled('page.css');
// The licence of three.js asks to go with every copy of it.
const parts = {
  '%SCRIPT%': script,
  '%SCRIPT_HASH%': hash(script),
  '%STYLE%': style,
  '%STYLE_HASH%': hash(style),
  '%LICENCE%': escaped(readFileSync('node_modules/three/LICENSE', 'utf8')),
};
const page = readFileSync('page.html', 'utf8').replace(/%[A-Z_]+%/g, mark => parts[mark] ?? mark);

const delimiter = 'scene_page';
if (page.split('%DATA%').length !== 2) throw new Error('page.html must have one %DATA%');
if (/<\/script|<!--/i.test(script) || page.includes(')' + delimiter + '"')) throw new Error('the bundle cannot be embedded');
writeFileSync(process.argv[2], `// Made by src/cli/page/build.mjs.

#include "cli/page/scene_page_template.hpp"

#ifdef __clang__
#pragma clang diagnostic ignored "-Woverlength-strings"
#endif

namespace polhode::cli {

const std::string_view page_template = R"${delimiter}(${page})${delimiter}";

}  // namespace polhode::cli
`);
