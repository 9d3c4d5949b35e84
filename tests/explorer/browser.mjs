// A headless Chromium, controlled by the DevTools protocol through a pipe: messages in JSON, each ended by a zero.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

export class Browser {
  static async open(command, url, { width = 1280, height = 900, dark = false, mobile = false, still = false } = {}) {
    const browser = new Browser(command);
    const { targetId } = await browser.call('Target.createTarget', { url: 'about:blank' }, null);
    ({ sessionId: browser.session } = await browser.call('Target.attachToTarget', { targetId, flatten: true }, null));
    for (const domain of ['Page', 'Runtime', 'Log']) await browser.call(`${domain}.enable`);
    await browser.call('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: mobile ? 2 : 1, mobile });
    await browser.call('Emulation.setEmulatedMedia', { features: [
      { name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' }, { name: 'prefers-reduced-motion', value: still ? 'reduce' : '' }] });
    await browser.call('Page.navigate', { url });
    return browser;
  }

  constructor(command) {
    this.profile = mkdtempSync(join(tmpdir(), 'explorer-'));
    // Root in a container has no sandbox, and a test's machine has no graphics.
    this.child = spawn(command, ['--headless', '--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage', '--no-first-run',
      `--user-data-dir=${this.profile}`, '--remote-debugging-pipe'], { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
    this.waiting = new Map();
    this.complaints = [];
    this.last = 0;
    let rest = '';
    this.child.stdio[4].on('data', (data) => {
      const messages = (rest + data).split('\0');
      rest = messages.pop();
      for (const message of messages) this.#take(JSON.parse(message));
    });
    this.child.on('exit', () => { for (const { reject } of this.waiting.values()) reject(new Error('the browser has ended')); });
  }

  call(method, params = {}, sessionId = this.session) {
    const id = ++this.last;
    this.child.stdio[3].write(JSON.stringify({ id, method, params, ...(sessionId && { sessionId }) }) + '\0');
    return new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject }));
  }
  // The value of an expression in the page.
  async value(expression) {
    const { result, exceptionDetails } = await this.call('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(`${expression}: ${exceptionDetails.exception?.description ?? exceptionDetails.text}`);
    return result.value;
  }
  async until(expression, seconds = 120) {
    for (const end = Date.now() + 1000 * seconds; Date.now() < end; await new Promise((done) => setTimeout(done, 50)))
      if (await this.value(expression)) return;
    throw new Error(`not within ${seconds} s: ${expression}; ${this.complaints}`);
  }
  // Presses and releases a key.
  async press(key, code = key, text = undefined) {
    const codes = { ArrowRight: 39, ArrowLeft: 37, ArrowUp: 38, ArrowDown: 40, Home: 36, End: 35, Enter: 13, Tab: 9, ' ': 32, '.': 190 };
    const event = { key, code, windowsVirtualKeyCode: codes[key] ?? 0, ...(text && { text }) };
    await this.call('Input.dispatchKeyEvent', { type: text ? 'keyDown' : 'rawKeyDown', ...event });
    await this.call('Input.dispatchKeyEvent', { type: 'keyUp', ...event });
  }
  async click(selector) {
    const { x, y } = await this.value(`(() => { const it = document.querySelector(${JSON.stringify(selector)}); it.scrollIntoView({ block: 'center' });
      const { left, top, width, height } = it.getBoundingClientRect(); return { x: left + width / 2, y: top + height / 2 }; })()`);
    for (const type of ['mousePressed', 'mouseReleased']) await this.call('Input.dispatchMouseEvent', { type, x, y, button: 'left', clickCount: 1 });
  }
  async picture(beyondViewport = false) {
    const { data } = await this.call('Page.captureScreenshot', { format: 'png', captureBeyondViewport: beyondViewport });
    return Buffer.from(data, 'base64');
  }

  async close() {
    const ended = new Promise((resolve) => this.child.on('exit', resolve));
    this.child.stdio[3].write(JSON.stringify({ id: ++this.last, method: 'Browser.close' }) + '\0');
    setTimeout(() => this.child.kill('SIGKILL'), 5000).unref();
    await ended;
    rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
  }

  #take({ id, result, error, method, params }) {
    if (method === 'Runtime.exceptionThrown') this.complaints.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === 'Log.entryAdded' && params.entry.level === 'error') this.complaints.push(params.entry.text);
    const waiting = this.waiting.get(id);
    this.waiting.delete(id);
    if (error) waiting?.reject(new Error(`${error.message}`));
    else waiting?.resolve(result);
  }
}
