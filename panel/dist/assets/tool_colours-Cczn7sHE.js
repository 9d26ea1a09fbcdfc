const e="#b8bcc2",o=["#56b4e9","#e69f00","#009e73","#cc79a7","#0072b2","#d55e00","#f0e442"];function t(c){return c===0?e:o[(c-1)%o.length]??e}export{t as c};
