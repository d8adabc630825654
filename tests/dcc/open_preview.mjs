// SPDX-License-Identifier: Apache-2.0
// open_preview.mjs CHROMIUM PAGE PICTURE: opens a page of vug preview in a browser without a network,
// takes a screenshot, and prints the contents of the page as JSON.
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const [program, file, picture] = process.argv.slice(2);
const browser = await chromium.launch({
  executablePath: program,
  args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
});
try {
  const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
  const said = [], asked = [];
  page.on('console', (line) => { if (['error', 'warning'].includes(line.type())) said.push(line.text()); });
  page.on('pageerror', (error) => said.push(String(error)));
  page.on('request', (request) => { if (!/^(data|blob):/.test(request.url())) asked.push(request.url()); });
  await page.goto(pathToFileURL(file).href);
  await page.waitForFunction(() => document.documentElement.dataset.ready, null, { timeout: 120000 });
  await page.screenshot({ path: picture });
  const shown = await page.evaluate(() => ({
    ...document.documentElement.dataset,
    title: document.title,
    heading: document.querySelector('h1').textContent,
    count: document.querySelector('#count').textContent,
    trouble: document.querySelector('#trouble').textContent,
    marked: document.querySelectorAll('script').length,
    pages: Object.fromEntries([...document.querySelectorAll('.page')].map((each) => [each.id, each.textContent])),
    pictureWidth: document.querySelector('img.picture')?.naturalWidth ?? 0,
  }));
  // The canvas alone: each key changes its picture, and H restores the first one.
  const look = async () => (await page.locator('#view').screenshot()).toString('base64');
  const press = async (key) => {
    await page.keyboard.press(key);
    await page.waitForTimeout(300);
    return look();
  };
  await page.keyboard.press('p');
  await page.waitForTimeout(300);
  const first = await look();
  const changes = {};
  for (const key of ['f', '[']) changes[key] = await press(key) !== first;
  await page.keyboard.press(']');
  changes.h = await press('h') === first;
  // The standard deviation of the brightness of the model's pixels: 0 for a blank canvas.
  const spread = await page.evaluate(async (png) => {
    const image = new Image();
    image.src = `data:image/png;base64,${png}`;
    await image.decode();
    const pixels = new OffscreenCanvas(160, 90).getContext('2d');
    pixels.drawImage(image, 0, 0, 160, 90);
    const { data } = pixels.getImageData(0, 0, 160, 90);
    let sum = 0, squares = 0;
    for (let i = 0; i < data.length; i += 4) {
      sum += data[i + 1];
      squares += data[i + 1] ** 2;
    }
    const count = data.length / 4;
    return Math.sqrt(squares / count - (sum / count) ** 2);
  }, first);
  console.log(JSON.stringify({ ...shown, spread, changes, said, asked }));
} finally {
  await browser.close();
}
