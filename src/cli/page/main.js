import './errors.js';

import {check} from './check.js';
import {motion} from './interpolation.js';
import {player} from './player.js';
import {element, show_report} from './report.js';
import {stage} from './stage.js';

const data = JSON.parse(document.getElementById('data').textContent);

const has_webgl = () => {
  const canvas = document.createElement('canvas');
  return Boolean(window.WebGL2RenderingContext && canvas.getContext('webgl2'));
};

const show_key = (path, picture) => {
  const key = document.getElementById('key');
  const say = (property, text) => {
    const item = element('li', text);
    const dash = element('i');
    dash.style.background = `var(${property})`;
    item.prepend(dash);
    key.append(item);
  };
  ['greatest', 'intermediate', 'least'].forEach((name, i) => say(['--axis-x', '--axis-y', '--axis-z'][i], `${'xyz'[i]}, axis of the ${name} moment`));
  if (picture.scale) say('--polhode', 'ω and its polhode in the body');
  if (picture.scale && path.attitudes) say('--herpolhode', 'herpolhode of ω in space');
  if (picture.momentum) say('--momentum', 'angular momentum J');
};

const show_motion = () => {
  const holder = document.getElementById('view');
  document.getElementById('stage').hidden = false;
  if (!has_webgl()) {
    holder.replaceWith(element('p', 'This browser has no WebGL 2, with which the body would be drawn.', 'note'));
    for (const controls of document.querySelectorAll('.controls')) controls.hidden = true;
    return;
  }
  const path = new motion(data);
  const picture = new stage(holder, data, path);
  show_key(path, picture);
  const choice = (id, is_possible, use) => {
    const box = document.getElementById(id);
    document.getElementById(`${id}_choice`).hidden = !is_possible;
    box.disabled = !is_possible;
    box.addEventListener('change', () => use(box.checked));
  };
  choice('follow', Boolean(path.attitudes), is_chosen => {
    picture.follows = is_chosen;
    picture.render();
  });
  choice('ellipsoid', Boolean(picture.shell), is_chosen => picture.show_ellipsoid(is_chosen));
  const remarks = [];
  if (data.stride > 1) remarks.push(`Of the samples every ${data.stride}th is drawn.`);
  if (!path.attitudes) remarks.push('The scene does not ask for the attitude: this is seen from the body.');
  if (path.is_sparse) {
    remarks.push('Between two samples the body turns too far for its motion to be drawn: it is shown at the samples only. Give [time] more samples or an earlier end.');
  }
  const sampling = document.getElementById('sampling');
  sampling.textContent = remarks.join(' ');
  sampling.hidden = remarks.length === 0;
  const play = new player(data, picture);
  if (location.hash === '#check') check(picture, play);
};

show_report(data);
if (data.t && data.t.length > 1) show_motion();
