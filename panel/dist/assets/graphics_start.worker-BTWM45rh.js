!function(){"use strict";try{new OffscreenCanvas(1,1).getContext("webgl2")?.finish()}finally{postMessage("started")}}();
