// NAME.html#check draws, scrubs, plays and uses the keys, and says in the page's attributes what came of it.

const root = document.documentElement;
const say = (name, holds) => {
  root.dataset[name] = holds ? 'yes' : 'no';
};

// How much is drawn, and a number that changes with it.
const picture_of = picture => {
  picture.render();
  const gl = picture.renderer.getContext();
  const pixels = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
  gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let drawn = 0;
  let sum = 0;
  for (let i = 0; i < pixels.length; i += 4) {
    if (pixels[i + 3] === 0) continue;
    ++drawn;
    sum = (sum * 31 + i + pixels[i]) % 1000003;
  }
  return {drawn, sum};
};

export const check = (picture, play) => {
  const gl = picture.renderer.getContext();
  const press = key => document.body.dispatchEvent(new KeyboardEvent('keydown', {key, bubbles: true}));
  const begin = picture_of(picture);
  say('drawn', begin.drawn > 1000);
  play.slider.value = '3700';
  play.slider.dispatchEvent(new Event('input'));
  const scrubbed = picture_of(picture);
  say('scrubbed', scrubbed.sum !== begin.sum && play.place === .37);
  press('End');
  const at_end = play.place;
  press('Home');
  press('ArrowRight');
  const speed = play.speed.value;
  press('+');
  say('keys', at_end === 1 && play.place === 1 / (play.count - 1) && Number(play.speed.value) > Number(speed));
  press('-');
  if (picture.path.attitudes) press('b');
  const from_body = picture_of(picture);
  if (picture.path.attitudes) press('b');
  if (picture.shell) press('e');
  const with_ellipsoid = picture_of(picture);
  if (picture.shell) press('e');
  say('choices', from_body.drawn > 1000 && with_ellipsoid.drawn > 1000 && (!picture.shell || with_ellipsoid.sum !== from_body.sum));
  root.dataset.gl = String(gl.getError());
  const before = play.place;
  press(' ');
  const look = left => {
    say('played', play.place > before);
    if (play.place > before) play.stop();
    else if (left > 0) setTimeout(look, 100, left - 1);
    picture_of(picture);  // takes time also where the browser's clock does not run by itself
  };
  setTimeout(look, 100, 150);
};
