// Uses the gallery as a person would and writes what it found into <pre id="selftest">, a line a check. The page is the
// one that gallery_test.cpp makes: exercise 01.1 with a.png (pixel (x, y) is (x, y, 7)), b.png (y, x, 200), three frames
// and a printout.
'use strict';

const report = [];
const check = (name, holds, found = '') => report.push(`${holds ? 'ok' : 'not ok'} ${name}${holds ? '' : `: ${found}`}`);
const by_selector = (selector) => document.querySelector(selector);

/** Waits until something holds. Pictures are decoded in the background, which the browser's virtual clock does not wait
 * for: so many short waits. */
async function until(holds) {
  for (let i = 0; i < 100000 && !holds(); ++i) await new Promise((resolve) => setTimeout(resolve, 1));
  if (!holds()) report.push(`not ok waited in vain until ${holds}`);
}

/** A mouse event in the middle of a picture's pixel as it lies on the canvas now. */
function event_at(type, x, y, more = {}) {
  const box = viewer.canvas.getBoundingClientRect();
  const ratio = box.width / viewer.canvas.width;
  return new (type === 'wheel' ? WheelEvent : PointerEvent)(type, {bubbles: true, cancelable: true,
    clientX: box.left + (viewer.x + (x + 0.5) * viewer.zoom) * ratio,
    clientY: box.top + (viewer.y + (y + 0.5) * viewer.zoom) * ratio, ...more});
}

/** What the canvas shows of pixel (x, y): every colour found in its square. */
function shown(x, y) {
  const data = viewer.canvas.getContext('2d').getImageData(viewer.x + x * viewer.zoom, viewer.y + y * viewer.zoom,
    viewer.zoom, viewer.zoom).data;
  const colors = new Set();
  for (let i = 0; i < data.length; i += 4) colors.add(data.slice(i, i + 3).join(' '));
  return [...colors].join(' | ');
}

const readout = () => by_selector('#readout').textContent;

async function try_page() {
  const sources = [...document.querySelectorAll('[src], link[href]')].map((node) => node.getAttribute('src') || node.href);
  check('every source is in the page', sources.length > 0 && sources.every((source) => source.startsWith('data:')), sources);
  check('printouts are text', by_selector('pre:not(#selftest)').textContent === '(5,5) <6,6>\n', by_selector('pre').outerHTML);
  check('exercise has id and title', by_selector('h3').textContent === '01.1A square & more', by_selector('h3').textContent);
  check('pictures have a text alternative', [...document.images].every((image) => image.alt));
}

async function try_pixels() {
  by_selector('.picture').click();
  await until(() => viewer.left);
  check('a click opens the viewer', by_selector('#viewer').open);
  viewer.canvas.dispatchEvent(event_at('pointermove', 9, 4));
  check('readout gives place and value', /\(9, 4\)\s+9 4 7$/.test(readout()), readout());
  const before = viewer.zoom;
  viewer.canvas.dispatchEvent(event_at('wheel', 9, 4, {deltaY: -1}));
  check('the wheel zooms', viewer.zoom === 2 * before, viewer.zoom);
  viewer.cursor = null;
  viewer.draw();
  check('pixels are hard', shown(9, 4) === '9 4 7' && shown(10, 4) === '10 4 7', `${shown(9, 4)} and ${shown(10, 4)}`);
  by_selector('#smaller').click();
  check('the button zooms out', viewer.zoom === before, viewer.zoom);
  viewer.look(3, 3);
  viewer.canvas.dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowRight'}));
  check('arrow keys move to the next pixel', readout().startsWith('(4, 3)'), readout());
}

async function try_slider() {
  by_selector('#close').click();
  check('the viewer closes', !by_selector('#viewer').open);
  by_selector('.compare').click();
  await until(() => viewer.left && viewer.right);
  const slide = (value) => {
    viewer.divider.value = value;
    viewer.divider.dispatchEvent(new Event('input'));
    return [shown(2, 8), shown(13, 8)].join(', ');
  };
  viewer.cursor = null;
  check('slider at the left shows the second picture', slide(0) === '8 2 200, 8 13 200', slide(0));
  check('slider at the right shows the first picture', slide(1000) === '2 8 7, 13 8 7', slide(1000));
  check('slider in the middle shows both', slide(500) === '2 8 7, 8 13 200', slide(500));
  viewer.canvas.dispatchEvent(event_at('pointermove', 13, 8));
  check('readout gives both values', readout().includes('13 8 7') && readout().includes('8 13 200'), readout());
  by_selector('#close').click();
}

async function try_frames() {
  const time = by_selector('.player input');
  const image = time.closest('figure').querySelector('img');
  const first = image.src;
  time.value = 2;
  time.dispatchEvent(new Event('input'));
  check('the frame slider changes the picture', time.max === '2' && image.src !== first);
}

(async () => {
  try {
    for (const part of [try_page, try_pixels, try_slider, try_frames]) await part();
  } catch (error) {
    report.push(`not ok ${error.stack}`);
  }
  document.body.append(Object.assign(document.createElement('pre'), {id: 'selftest', textContent: report.join('\n') + '\nend'}));
})();
