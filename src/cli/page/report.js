// The effects, with their certified values. Texts of the scene are set as text and never read as HTML.

const long_value = 160;  // characters, of which a value beyond is folded
const shown_of_long = 60;

export const element = (name, text, style) => {
  const result = document.createElement(name);
  if (text !== undefined) result.textContent = text;
  if (style) result.className = style;
  return result;
};

const in_words = name => name.replaceAll('_', ' ');

// 1.5…e-13: the digits shown are certain, and others follow.
const with_dots = value => {
  const exponent = value.indexOf('e');
  return exponent < 0 ? value + '…' : value.slice(0, exponent) + '…' + value.slice(exponent);
};

const interval_of = number =>
    number.lower === undefined || number.lower === null ? '' : `[${number.lower}, ${number.upper}]`;

// The text of a number, and whether its interval says more.
const text_of = number => {
  // Of bodies within uncertainties: the ends are what is asked for.
  if (number.range) return [`${number.value} ± ${number.radius} (from ${number.lower} to ${number.upper})`, false];
  const enough = Math.min(3, number.digits_asked ?? 3);
  if (!number.value) return [interval_of(number) || '—', false];
  // The nearest decimal with its error, where the ends share too few digits.
  if (!number.exact && (number.rounded || (number.digits ?? enough) < enough)) return [`${number.value} ± ${number.radius}`, true];
  if (!number.exact) return [with_dots(number.value), true];
  if (number.lower === undefined || number.lower === number.value) return [number.value, false];
  const is_short = number.rational && number.rational.length <= 40;
  return [(is_short ? number.rational + ' = ' : '') + with_dots(number.value), true];
};

const value_cell = number => {
  const cell = element('td');
  const [text, has_interval] = text_of(number);
  if (text.length > long_value) {
    const details = element('details', undefined, 'digits');
    details.append(element('summary', `${text.slice(0, shown_of_long)}… (${text.length} characters)`, 'value'));
    details.append(element('span', text, 'value'));
    cell.append(details);
  } else {
    cell.append(element('span', text, 'value'));
  }
  if (number.unit) cell.append(' ', element('span', number.unit, 'unit'));
  if (has_interval) cell.append(element('span', interval_of(number), 'interval'));
  return cell;
};

const row = (table, name, cell) => {
  const line = table.insertRow();
  const head = element('th', in_words(name));
  head.scope = 'row';
  line.append(head, cell);
};

const svg = (name, attributes, text) => {
  const result = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) result.setAttribute(key, value);
  if (text !== undefined) result.textContent = text;
  return result;
};

// About so many round numbers (1, 2 or 5 times a power of ten apart) within the range, with their texts.
export const round_ticks = (from, to, count) => {
  const power = 10 ** Math.floor(Math.log10((to - from) / count));
  const step = power * ([1, 2, 5].find(k => k * power * count >= (to - from) * .999) ?? 10);
  const places = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const text = v => Math.abs(v) < 1e6 && places <= 6 ? v.toFixed(places) : String(Number(v.toPrecision(6)));
  const result = [];
  for (let k = Math.ceil(from / step - 1e-9); k * step <= to + step * 1e-9; ++k) result.push([k * step, text(k * step)]);
  return result;
};

// A curve over its first column.
const chart = (name, {columns, rows}) => {
  const width = 640;
  const height = 260;
  const [left, right, top, bottom] = [64, 14, 28, 34];
  const range = k => {
    const least = rows.reduce((found, one) => Math.min(found, one[k]), Infinity);
    const greatest = rows.reduce((found, one) => Math.max(found, one[k]), -Infinity);
    const margin = Math.abs(least) / 2 || 1;
    return least < greatest ? [least, greatest] : [least - margin, greatest + margin];
  };
  const [x0, x1] = range(0);
  const [y0, y1] = range(1);
  const x = v => left + (width - left - right) * (v - x0) / (x1 - x0);
  const y = v => height - bottom - (height - top - bottom) * (v - y0) / (y1 - y0);
  const picture = svg('svg', {class: 'chart', viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': `${in_words(name)}: ${columns[1]} over ${columns[0]}`});
  for (const [v, label] of round_ticks(y0, y1, 5)) {
    picture.append(svg('line', {x1: left, x2: width - right, y1: y(v), y2: y(v)}));
    picture.append(svg('text', {x: left - 6, y: y(v) + 4, 'text-anchor': 'end'}, label));
  }
  for (const [v, label] of round_ticks(x0, x1, 6)) {
    picture.append(svg('line', {x1: x(v), x2: x(v), y1: height - bottom, y2: height - bottom + 4}));
    picture.append(svg('text', {x: x(v), y: height - bottom + 16, 'text-anchor': 'middle'}, label));
  }
  picture.append(svg('text', {x: 4, y: top - 14, 'font-style': 'italic'}, columns[1]));
  picture.append(svg('text', {x: width - right, y: height - 3, 'text-anchor': 'end', 'font-style': 'italic'}, columns[0]));
  // Where a regime ends, at c = 0, a phase is infinite: no line is drawn across.
  const infinite_at_0 = name === 'montgomery_curve';
  let path = '';
  rows.forEach((one, k) => {
    const apart = k === 0 || (infinite_at_0 && rows[k - 1][0] < 0 && one[0] > 0);
    path += `${apart ? 'M' : 'L'}${x(one[0]).toFixed(2)},${y(one[1]).toFixed(2)}`;
  });
  picture.append(svg('path', {d: path}));
  return picture;
};

const effect_section = (name, effect, curve) => {
  const section = element('section', undefined, 'effect');
  const head = element('header');
  head.append(element('h2', in_words(name)));
  const is_certified = effect.verdict === 'certified';
  head.append(element('span', is_certified ? 'certified' : 'not certified', `badge ${is_certified ? 'certified' : 'not'}`));
  section.append(head);
  if (effect.why) section.append(element('p', effect.why, 'note not'));
  const table = element('table');
  for (const [key, word] of Object.entries(effect.words ?? {})) row(table, key, element('td', word));
  for (const [key, number] of Object.entries(effect.numbers ?? {})) row(table, key, value_cell(number));
  if (table.rows.length) section.append(table);
  if (curve && curve.rows.length > 1) section.append(chart(name, curve));
  for (const remark of effect.remarks ?? []) section.append(element('p', remark, 'note'));
  return section;
};

export const show_report = data => {
  const report = data.report;
  document.title = data.title;
  document.getElementById('title').textContent = data.title;
  document.getElementById('source').textContent = data.source;
  document.getElementById('version').textContent = `Written by polhode ${report.polhode} from ${report.file}.`;
  const main = document.getElementById('effects');
  if (report.point) {
    const at = Object.entries(report.point).map(([key, number]) => `${key} = ${number.rational ?? number.value}`);
    main.append(element('p', `At ${at.join('; ')}.`, 'note'));
  }
  for (const remark of report.remarks ?? []) main.append(element('p', remark, 'note'));
  const tools = element('div', undefined, 'tools');
  const choice = element('label');
  const box = element('input');
  box.type = 'checkbox';
  box.id = 'enclosures';
  box.addEventListener('change', () => main.classList.toggle('enclosures', box.checked));
  choice.append(box, ' show the enclosing intervals');
  tools.append(choice);
  main.append(tools);
  for (const [name, effect] of Object.entries(report.effects)) {
    if (effect.wanted) main.append(effect_section(name, effect, data.curves?.[name]));
  }
};
