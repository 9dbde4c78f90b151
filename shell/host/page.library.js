// SPDX-License-Identifier: MIT
// The functions of the page that the application calls, as an Emscripten library. Each forwards to Module.page, the
// object that the page passes to createApp({canvas, page}). Functions that the page omits do nothing.
addToLibrary({
  $callPage: (name, ...args) => Module['page']?.[name]?.(...args),

  gs_page_max_workers__deps: ['$callPage'],
  gs_page_max_workers: () => callPage('maxWorkers') ?? navigator.hardwareConcurrency ?? 2,

  gs_page_start_search__deps: ['$callPage'],
  gs_page_start_search: (pointer, bytes, workers) => {
    callPage('startSearch', HEAPU8.slice(pointer, pointer + bytes), workers);
  },
  gs_page_start_trial__deps: ['$callPage', '$UTF8ToString'],
  gs_page_start_trial: (pointer, bytes, workers, words, finished, total) => {
    callPage('startTrial', HEAPU8.slice(pointer, pointer + bytes), workers, { words: UTF8ToString(words), finished, total });
  },
  gs_page_start_queued__deps: ['$callPage', '$UTF8ToString'],
  gs_page_start_queued: (pointer, bytes, workers, words) => {
    callPage('startQueued', HEAPU8.slice(pointer, pointer + bytes), workers, UTF8ToString(words));
  },
  gs_page_start_preview__deps: ['$callPage'],
  gs_page_start_preview: (pointer, bytes, workers) => {
    callPage('startPreview', HEAPU8.slice(pointer, pointer + bytes), workers);
  },
  gs_page_store_found__deps: ['$callPage', '$UTF8ToString'],
  gs_page_store_found: (id, text) => { callPage('storeFound', UTF8ToString(id), UTF8ToString(text)); },
  gs_page_ask_name__deps: ['$callPage', '$UTF8ToString'],
  gs_page_ask_name: (id, name, usual) => { callPage('askName', UTF8ToString(id), UTF8ToString(name), UTF8ToString(usual)); },
  gs_page_learn_from__deps: ['$callPage', '$UTF8ToString'],
  gs_page_learn_from: (id, more) => { callPage('learnFrom', UTF8ToString(id), more !== 0); },
  gs_page_open_dialog__deps: ['$callPage', '$UTF8ToString'],
  gs_page_open_dialog: (command) => { callPage('openDialog', UTF8ToString(command)); },
  gs_page_lab_ended__deps: ['$callPage'],
  gs_page_lab_ended: () => { callPage('labEnded'); },
  gs_page_save_text__deps: ['$callPage', '$UTF8ToString'],
  gs_page_save_text: (name, text) => { callPage('saveText', UTF8ToString(name), UTF8ToString(text)); },
  gs_page_pause_search__deps: ['$callPage'],
  gs_page_pause_search: () => { callPage('pauseSearch'); },
  gs_page_resume_search__deps: ['$callPage'],
  gs_page_resume_search: () => { callPage('resumeSearch'); },
  gs_page_stop_search__deps: ['$callPage'],
  gs_page_stop_search: () => { callPage('stopSearch'); },
  gs_page_start_transition_map__deps: ['$callPage'],
  gs_page_start_transition_map: (pointer, bytes, generation) => {
    callPage('startTransitionMap', HEAPU8.slice(pointer, pointer + bytes), generation);
  },
  gs_page_stop_transition_map__deps: ['$callPage'],
  gs_page_stop_transition_map: () => { callPage('stopTransitionMap'); },
  gs_page_start_plan__deps: ['$callPage'],
  gs_page_start_plan: (pointer, bytes, generation) => {
    callPage('startPlan', HEAPU8.slice(pointer, pointer + bytes), generation);
  },
  gs_page_stop_plan__deps: ['$callPage'],
  gs_page_stop_plan: () => { callPage('stopPlan'); },

  gs_page_status__deps: ['$callPage', '$UTF8ToString'],
  gs_page_status: (sentence) => { callPage('status', UTF8ToString(sentence)); },
  gs_page_document_changed__deps: ['$callPage', '$UTF8ToString'],
  gs_page_document_changed: (title) => { callPage('documentChanged', UTF8ToString(title)); },
  gs_page_first_frame__deps: ['$callPage'],
  gs_page_first_frame: () => { callPage('firstFrame'); },

  // If the page does not handle this, the canvas only loses the focus.
  gs_page_leave_canvas__deps: ['$callPage'],
  gs_page_leave_canvas: (direction) => {
    if (Module['page']?.['leaveCanvas']) callPage('leaveCanvas', direction);
    else Module['canvas'].blur();
  },

  // GPU fences for frame_pace.cpp. Not Emscripten's: its table of fences grows with every fence ever created.
  $frameFence: 'null',
  gs_fence_frame__deps: ['$frameFence'],
  gs_fence_frame: () => { frameFence = GLctx.fenceSync(GLctx.SYNC_GPU_COMMANDS_COMPLETE, 0); }, // null in a lost context
  gs_frame_is_drawn__deps: ['$frameFence'],
  gs_frame_is_drawn: () => !frameFence || GLctx.clientWaitSync(frameFence, 0, 0) !== GLctx.TIMEOUT_EXPIRED,
  gs_forget_fence__deps: ['$frameFence'],
  gs_forget_fence: () => {
    GLctx.deleteSync(frameFence);
    frameFence = null;
  },
});
