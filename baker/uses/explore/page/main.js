// SPDX-License-Identifier: MIT
// Starts the page with the data embedded beside this script in the HTML.

import {readArrays} from './arrays.js';
import style from './page.css';
import markup from './page.html';
import {Page} from './page.js';

const script = document.currentScript, host = script.parentElement;

async function begin() {
  const facts = JSON.parse(host.querySelector('.facts').textContent);
  const text = host.querySelector('.arrays').textContent.trim();
  const shown = host.querySelector('.shown');
  const root = shown.attachShadow({mode: 'open'});
  root.innerHTML = `<style>${style}</style>${markup}`;
  try {
    if (typeof DecompressionStream === 'undefined')
      throw new Error('This browser is too old for the page: it has no DecompressionStream. Browsers from 2023 on have.');
    host.page = new Page(root, facts, await readArrays(text, facts.arrays), 'embedded' in host.dataset);
  } catch (problem) {
    root.querySelector('.note').textContent = problem.message;
    throw problem;
  }
  return host.page;
}

host.ready = begin();
