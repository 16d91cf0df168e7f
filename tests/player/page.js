// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the script of an animated page in Node, without a browser:
//
//     node page.js PAGE.html[#test=T] [CODE]    prints the value of CODE after the script; default: the line of the state
//
// The document consists of the tags of the page; drawing does nothing. CODE may call `frames(count, ms)`, which shows
// `count` frames, one each `ms` milliseconds, and returns the largest number of calls of `rates` between two frames.
"use strict";
const fs = require("fs");
const vm = require("vm");

const [file, hash = ""] = process.argv[2].split("#");
const text = fs.readFileSync(file, "utf8");
const [, script] = /<script>\n([^]*?)<\/script>/.exec(text);

const drawing = new Proxy({}, { get: () => () => {}, set: () => true });

function element([, tag, attributes], options) {
  const values = Object.fromEntries([...attributes.matchAll(/([\w-]+)(?:="([^"]*)")?/g)].map(([, name, value = ""]) => [name, value]));
  const dataset = Object.fromEntries(Object.entries(values).filter(([name]) => name.startsWith("data-")).map(([name, value]) => [name.slice(5), value]));
  const made = { tagName: tag.toUpperCase(), values, dataset, options, textContent: "", style: {}, listeners: {}, clientWidth: 400, clientHeight: 300 };
  return Object.assign(made, {
    id: values.id,
    hidden: "hidden" in values,
    value: values.value,
    name: values.name,
    getContext: () => drawing,
    getAttribute: (name) => made.values[name],
    setAttribute: (name, value) => { made.values[name] = value; },
    addEventListener: (name, act) => { made.listeners[name] = act; },
    nextElementSibling: { textContent: "" },
    add: (option) => { made.replaceChildren(...made.options, option); },
    replaceChildren: (...added) => { made.options = added; made.value ??= added[0].value; },
  });
}

const elements = [...text.replace(script, "").matchAll(/<(\w+)([^>]*)>/g)].map((found) => element(found, []));
const selects = [...text.matchAll(/<select id="([\w-]+)"[^>]*>([^]*?)<\/select>/g)];
for (const [, id, inner] of selects) {
  const select = elements.find((each) => each.id === id);
  select.options = [...inner.matchAll(/<option([^>]*)>([^<]*)/g)].map(([, given, shown]) => ({ value: (/value="([^"]*)"/.exec(given) || [0, shown])[1], given }));
  select.value = ((select.options.find(({ given }) => given.includes("selected")) || select.options[0]) || {}).value;
}

const matches = (selector) => {
  const [, tag, name, value] = /^(\w+)(?:\[([\w-]+)(?:=(\w+))?\])?$/.exec(selector);
  return (each) => each.tagName === tag.toUpperCase() && (!name || (name in each.values && (!value || each.values[name] === value)));
};
const clock = { now: 0, frame: null };
const window = { addEventListener: () => {}, devicePixelRatio: 1 };
const context = vm.createContext({
  window,
  clock,
  location: { hash: hash && `#${hash}` },
  history: { replaceState: () => {} },
  performance: { now: () => clock.now },
  requestAnimationFrame: (frame) => { clock.frame = frame; },
  matchMedia: () => ({ matches: true }),
  getComputedStyle: () => ({ getPropertyValue: () => "#000" }),
  URLSearchParams,
  Option: function Option(shown, value) { Object.assign(this, { textContent: shown, value: String(value) }); },
  document: {
    documentElement: {},
    addEventListener: () => {},
    getElementById: (id) => elements.find((each) => each.id === id) || null,
    querySelectorAll: (selector) => elements.filter(matches(selector)),
  },
});
const frames = `
function frames(count, ms) {
  let most = 0;
  for (let i = 0; i < count && clock.frame; i += 1) {
    const [frame, before] = [clock.frame, calls];
    clock.frame = null;
    clock.now += ms;
    frame(clock.now);
    most = Math.max(most, calls - before);
  }
  return most;
}
let calls = 0;
const rates_of_page = rates;
rates = (x) => { calls += 1; return rates_of_page(x); };
`;
const value = vm.runInContext(`${script}\n${frames}\n${process.argv[3] || 'by("state").textContent'}`, context);
console.log(typeof value === "string" ? value : JSON.stringify(value));
