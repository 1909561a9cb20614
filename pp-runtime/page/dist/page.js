"use strict";(()=>{var q_=i=>i.replace("-","\u2212"),Gi=i=>i.rotary?"\xB0":"mm";function He(i,t){if(!Number.isFinite(i))return"\u2013";let e=i.toFixed(t);return q_(Number(e)===0?e.replace("-",""):e)}function xe(i){if(!Number.isFinite(i))return"\u2013";let t=Math.abs(i);return He(i,t>=1e3?0:t>=100?1:t>=1?2:3).replace(/(\.\d*?)0+$/,"$1").replace(/\.$/,"")}function ni(i){if(!Number.isFinite(i))return"\u2013";let t=Math.round(i*10),e=Math.floor(t/36e3),n=Math.floor(t/600)%60,s=t%600/10,r=o=>o.padStart(o.includes(".")?4:2,"0");return e>0?`${e}:${r(String(n))}:${r(String(Math.floor(s)))}`:`${n}:${r(s.toFixed(1))}`}function Sl(i){if(i.number===0)return"none yet";let t=i.gauge_length===null?"gauge length unknown":`gauge ${xe(i.gauge_length)}`;return[`T${i.number}`,i.name||(i.kind==="unknown"?"":i.kind),t].filter(e=>e!=="").join(" \xB7 ")}var $_={light:[.3,.72],dark:[.5,.93]},zu=[[0,292,.15],[.25,256,.14],[.5,205,.11],[.75,152,.14],[1,102,.16]];function Mp(i,t){let e=Math.min(Math.max(i,0),1),n=Math.max(1,zu.findIndex(f=>f[0]>=e)),[s,r,o]=zu[n-1],[a,l,c]=zu[n],h=(e-s)/(a-s),[u,d]=$_[t];return to(u+e*(d-u),o+h*(c-o),r+h*(l-r))}function to(i,t,e){let n=e*Math.PI/180;for(let s=t;;s-=.001){let r=Y_(i,s*Math.cos(n),s*Math.sin(n));if(s<=0||r.every(o=>o>=-1e-6&&o<=1+1e-6))return r.map(o=>Z_(Math.min(Math.max(o,0),1)))}}function Y_(i,t,e){let n=(i+.3963377774*t+.2158037573*e)**3,s=(i-.1055613458*t-.0638541728*e)**3,r=(i-.0894841775*t-1.291485548*e)**3;return[4.0767416621*n-3.3077115913*s+.2309699292*r,-1.2684380046*n+2.6097574011*s-.3413193965*r,-.0041960863*n-.7034186147*s+1.707614701*r]}var Z_=i=>i<=.0031308?12.92*i:1.055*i**(1/2.4)-.055;var Vu=[[.5,.15,255],[.62,.16,50],[.6,.12,170],[.52,.19,350],[.66,.14,90],[.45,.16,300],[.66,.11,225],[.5,.12,140]];function Ms(i,t){let[e,n,s]=Vu[i%Vu.length],r=Math.floor(i/Vu.length)%2,o=(t==="dark"?.17:0)+(t==="dark"?-.1:-.12)*r;return to(e+o,n,s)}var Vn=i=>`rgb(${i.map(t=>Math.round(t*255)).join(" ")})`;var ws=256;function Tp(i){let{machine:t,tolerance_mm:e}=i.head,n=[j_(i),J_(i)];return t.joints.forEach((s,r)=>{s.held||n.push(Ml(`axis.${s.letter}`,`${s.letter} value`,Gi(s),i.axes[r],i,{}))}),t.joints.some(s=>s.rotary&&!s.held)&&n.push(Ml("rotary-speed","rotary speed","\xB0/min",K_(i),i,{fromZero:!0})),n.push(Ml("feed","programmed feed","mm/min",i.feed.map(s=>s>0?s:Number.NaN),i,{}),Ml("error","path error","\xB5m",i.errorUm,i,{fromZero:!0,mark:{value:e*1e3,label:"tolerance"}})),n}function K_(i){let t=new Float64Array(i.count).fill(Number.NaN);return i.head.machine.joints.forEach((e,n)=>{!e.rotary||e.held||i.speeds[n].forEach((s,r)=>{t[r]>=s||(t[r]=s)})}),t}function j_(i){let{kinds:t}=i.head,n=[...t.filter(s=>s!=="start"&&s!=="dwell")].sort((s,r)=>wp(s)-wp(r));return Ep("motion","feed / rapid",n,s=>n.indexOf(t[i.kind[s]]),i.count)}var wp=i=>i==="feed"?0:i==="rapid"?1:2;function J_(i){let t=i.head.operations.map(e=>`${e.number}. ${e.name}`);return Ep("operation","operation",t,e=>i.operation[e],i.count)}function Ep(i,t,e,n,s){return{name:i,label:t,shares:()=>{let o=new Float32Array(s);for(let a=0;a<s;a+=1){let l=n(a);o[a]=l>=0&&l<e.length?(l%ws+.5)/ws:-1}return o},table:o=>Array.from({length:ws},(a,l)=>Ms(l,o)),legend:o=>({entries:e.map((a,l)=>({label:a,colour:Vn(Ms(l%ws,o)),dashed:a==="rapid"}))})}}function Ml(i,t,e,n,s,r){let o=Q_(n,s,r);return{name:i,label:t,shares:()=>{let a=o.max-o.min;return Float32Array.from(n,l=>Number.isNaN(l)?-1:a>0?Math.min(Math.max((l-o.min)/a,0),1):.5)},table:a=>Array.from({length:ws},(l,c)=>Mp(c/(ws-1),a)),legend:()=>({scale:{unit:e,mark:r.mark??null,...o}})}}function Q_(i,t,e){let n=i.filter((o,a)=>!Number.isNaN(o)&&!t.isStart(a)).sort();if(n.length===0)return{min:0,max:0,beyond:!1};let s=n[n.length-1],r=s;if(e.fromZero){let o=n[Math.floor((n.length-1)*.995)];o>0&&o<s/2&&(r=o),e.mark&&(r=Math.max(r,e.mark.value))}return{min:e.fromZero?0:n[0],max:r,beyond:s>r}}var eo=(i,t)=>`${xe(i)} ${t}`;var Gu="[-+]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][-+]?\\d+)?",tx=new RegExp(`^\\s*GOTO\\s*/\\s*(${Gu}(?:\\s*,\\s*${Gu}){2}(?:(?:\\s*,\\s*${Gu}){3})?)\\s*$`,"i"),ex=/^\s*(?:TRANS|TRACUT|COPY|ORIGIN|ROTATE|ROTABL|MIRROR|CUTCOM\s*\/\s*(?!OFF))/i,nx=["record","approach"];function ix(i){let t=tx.exec(i);if(!t)return null;let[e,n,s,...r]=t[1].split(",").map(Number);return{tip:[e,n,s],axis:r.length===3?[r[0],r[1],r[2]]:null}}var wl=class{constructor(t,e){this.program=t;this.text=e;let n=!1,s=!0,r=!1;for(let o=1;o<=(e?.count??0);o+=1){let a=e?.line(o)??"";/^\s*UNITS\s*\//i.test(a)&&(n=/\/\s*MM\s*$/i.test(a),s&&=n),ex.test(a)&&(s=!1),/^\s*CYCLE\s*\//i.test(a)&&(r=!/\/\s*OFF/i.test(a)),r&&this.inCycle.add(o)}this.comparable=n&&s}program;text;comparable;inCycle=new Set;at(t){let{program:e,text:n}=this,s=e.clLine[t];return!this.comparable||n===null||this.inCycle.has(s)||e.clLine[t+1]===s||!nx.includes(e.head.reasons[e.reason[t]])?null:ix(n.line(s))}};var Me=(i,t)=>[i[0]+t[0],i[1]+t[1],i[2]+t[2]],tn=(i,t)=>[i[0]-t[0],i[1]-t[1],i[2]-t[2]],Qt=(i,t)=>[i[0]*t,i[1]*t,i[2]*t],un=(i,t)=>i[0]*t[0]+i[1]*t[1]+i[2]*t[2],wn=i=>Math.hypot(i[0],i[1],i[2]),ci=(i,t)=>[i[1]*t[2]-i[2]*t[1],i[2]*t[0]-i[0]*t[2],i[0]*t[1]-i[1]*t[0]],no=i=>Qt(i,1/wn(i)),oa=(i,t)=>tn(i,Qt(t,un(i,t)));function io(i,t){for(let e of[t,[0,1,0],[1,0,0]]){let n=oa(e,i);if(wn(n)>.001)return no(n)}return[0,0,1]}var Ap=Math.PI/180,Cp=()=>[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1];function sx(i,t){let e=new Array(16);for(let n=0;n<4;n+=1)for(let s=0;s<4;s+=1)e[4*n+s]=i[s]*t[4*n]+i[4+s]*t[4*n+1]+i[8+s]*t[4*n+2]+i[12+s]*t[4*n+3];return e}var Hu=(i,t)=>[i[0]*t[0]+i[4]*t[1]+i[8]*t[2],i[1]*t[0]+i[5]*t[1]+i[9]*t[2],i[2]*t[0]+i[6]*t[1]+i[10]*t[2]];function rx(i,t,e){let[n,s,r]=i,o=Math.cos(e),a=Math.sin(e),l=1-o,c=[l*n*n+o,l*n*s+a*r,l*n*r-a*s,0,l*n*s-a*r,l*s*s+o,l*s*r+a*n,0,l*n*r+a*s,l*s*r-a*n,l*r*r+o,0,0,0,0,1],h=Hu(c,t);return c[12]=t[0]-h[0],c[13]=t[1]-h[1],c[14]=t[2]-h[2],c}function Wu(i,t,e){if(i.rotary)return rx(i.direction,t,i.sign*e*Ap);let n=Cp();for(let s=0;s<3;s+=1)n[12+s]=i.sign*e*i.direction[s];return n}function Rp(i,t,e){if(!i.rotary)return i.sign*un([t[12],t[13],t[14]],i.direction);let n=[(t[6]-t[9])/2,(t[8]-t[2])/2,(t[1]-t[4])/2],s=(t[0]+t[5]+t[10]-1)/2,r=i.sign*Math.atan2(un(n,i.direction),s)/Ap;return r+360*Math.round((e-r)/360)}function Pp(i,t){let e=[],n=Cp(),s=[0,0,0];for(let c=0;c<i.joints.length;c+=1){let h=i.joints[c];h.rotary&&(h.held||e.push(Hu(n,h.direction)),n=sx(n,Wu(h,s,t[c])))}if(e.length!==2)return null;let r=Hu(n,i.tool_axis),o=ci(e[0],r),a=ci(e[1],r),l=Math.max(wn(o),wn(a));return l<1e-12?0:wn(ci(o,a))/l}var ox=Math.sin(Math.PI/180),ax=255,lx=1e4/60,cx=3600/60,hx={number:0,name:"",kind:"unknown",diameter:null,corner_radius:null,length:null,flute_length:null,gauge_length:null,profile:null,first_point:0,points:0,seconds:0},ux={rewind:"rewind",course:"pole","lead-out":"retract",tolerance:"inserted",corner:"inserted"},Ts=class{constructor(t,e){this.head=t;let n=s=>{let r=e.get(s);if(!r)throw new Error(`the page has no column \`${s}\``);return r};this.count=t.points,this.axes=t.machine.joints.map(s=>n(`axis.${s.letter}`)),this.tip=[n("tip.x"),n("tip.y"),n("tip.z")],this.toolAxis=[n("tool.i"),n("tool.j"),n("tool.k")],this.line=n("line"),this.clLine=n("cl_line"),this.kind=n("kind"),this.reason=n("reason"),this.operation=n("operation"),this.placement=n("placement"),this.feed=n("feed"),this.legSeconds=n("seconds"),this.errorUm=n("error"),this.startKind=t.kinds.indexOf("start"),this.rapidKind=t.kinds.indexOf("rapid"),[this.timeS,this.countedS]=this.accumulateTime(),this.hasUnknownTimes=this.legSeconds.some((s,r)=>Number.isNaN(s)&&!this.isStart(r)),[this.block,this.blockFirst]=this.divideIntoBlocks(),this.blockShare=this.shareOfBlocks(),this.speeds=this.axes.map(s=>this.speedOf(s)),this.stretches=this.findStretches()}head;count;axes;tip;toolAxis;line;clLine;kind;reason;operation;placement;feed;legSeconds;errorUm;timeS;countedS;hasUnknownTimes;block;blockFirst;blockShare;speeds;stretches;findingRuns=new Map;startKind;rapidKind;isStart(t){return t===0||this.kind[t]===this.startKind}isRapid(t){return this.kind[t]===this.rapidKind}get blocks(){return this.blockFirst.length-1}get totalS(){return this.count===0?0:this.timeS[this.count-1]}tipAt(t){return[this.tip[0][t],this.tip[1][t],this.tip[2][t]]}axesAt(t){return this.axes.map(e=>e[t])}axesBetween(t){let e=Math.floor(t),n=Math.min(e+1,this.count-1),s=t-e;return s===0||n===e||this.isStart(n)?this.axesAt(e):this.axes.map(r=>r[e]+s*(r[n]-r[e]))}timeAt(t){let e=Math.floor(t),n=Math.min(e+1,this.count-1);return this.timeS[e]+(t-e)*(this.timeS[n]-this.timeS[e])}positionAt(t){let e=Es(this.timeS,t);if(e<=0)return 0;if(e>=this.count)return this.count-1;let n=this.timeS[e-1],s=this.timeS[e]-n;return s>0?e-1+(t-n)/s:e}static pointAt(t){return Math.ceil(t)}blockLast(t){return this.blockFirst[t+1]-1}pointOfLine(t){let e=-1;for(let n=0;n<this.blocks;n+=1){let s=this.line[this.blockFirst[n]];if(s===t)return this.blockLast(n);s>t&&(e<0||s<this.line[this.blockFirst[e]])&&(e=n)}return e<0?null:this.blockLast(e)}pointBefore(t){let e=-1;for(let n=0;n<this.blocks;n+=1){let s=this.line[this.blockFirst[n]];s<=t&&(e<0||s>this.line[this.blockFirst[e]])&&(e=n)}return e<0?0:this.blockLast(e)}findingStretches(t){let e=this.findingRuns.get(t);if(e)return e;let n=[];for(let s=0;s<this.blocks;s+=1){let r=this.line[this.blockFirst[s]];if(r<t.line||r>t.last_line)continue;let o=n.at(-1);o&&o.last===this.blockFirst[s]-1?o.last=this.blockLast(s):n.push({first:this.blockFirst[s],last:this.blockLast(s)})}if(n.length===0){let s=this.pointBefore(t.line);n.push({first:s+1,last:s})}return this.findingRuns.set(t,n),n}placementAt(t){return this.head.placements[this.placement[t]]}toolAt(t){return this.toolOfNumber(this.placementAt(t).tool)}toolOfNumber(t){return this.head.tools.find(e=>e.number===t)??{...hx,number:t}}setUpAt(t){return this.head.set_ups[this.placementAt(t).set_up]}limits(t,e){let{rotary:n,min:s,max:r}=this.head.machine.joints[t],o=n?0:this.head.placements[e].zero?.[t]??null,a=l=>l===null||o===null?null:l-o;return[a(s),a(r)]}placementRuns(){let t=[];for(let e=0;e<this.count;e+=1){let n=t.at(-1);n&&n.placement===this.placement[e]?n.last=e:t.push({placement:this.placement[e],first:e,last:e})}return t}setUpRange(t){let e=this.head.set_ups.map(n=>n.first_point);return[e[t]??0,e[t+1]??this.count]}reasonText(t){let e=this.reason[t];return e===ax?null:this.head.reason_texts[e]??this.head.reasons[e]??null}kindText(t){return this.head.kinds[this.kind[t]]??"motion"}isNotCompared(t){return this.kindText(t)==="feed"&&!this.isStart(t)&&Number.isNaN(this.errorUm[t])}accumulateTime(){let t=new Float64Array(this.count),e=new Float64Array(this.count);for(let n=0;n<this.count;n+=1){let s=this.legSeconds[n],r=s>0?s:0,o=Number.isNaN(s)&&!this.isStart(n)?this.assumedSeconds(n):r;t[n]=(n>0?t[n-1]:0)+o,e[n]=(n>0?e[n-1]:0)+r}return[t,e]}assumedSeconds(t){return this.head.machine.joints.reduce((e,n,s)=>{let r=Math.abs(this.axes[s][t]-this.axes[s][t-1]);return Math.max(e,r/(n.rotary?cx:lx))},0)}divideIntoBlocks(){let t=new Uint32Array(this.count),e=[];for(let n=0;n<this.count;n+=1)(n===0||this.line[n]!==this.line[n-1])&&e.push(n),t[n]=e.length-1;return e.push(this.count),[t,Uint32Array.from(e)]}shareOfBlocks(){let t=new Float64Array(this.count);for(let e=0;e<this.count;e+=1){let n=this.blockFirst[this.block[e]];t[e]=this.block[e]+(e-n+1)/(this.blockFirst[this.block[e]+1]-n)}return t}speedOf(t){let e=new Float64Array(this.count);for(let n=0;n<this.count;n+=1){let s=this.legSeconds[n];e[n]=this.isStart(n)||!(s>0)?Number.NaN:Math.abs(t[n]-t[n-1])/s*60}return e}findStretches(){let{machine:t,reasons:e}=this.head,n=e.map(a=>ux[a]??null),s=t.joints.flatMap((a,l)=>a.rotary&&!a.held?[l]:[]),r=[],o=new Float64Array(t.joints.length);for(let a=0;a<this.count;a+=1){let l=n[this.reason[a]]??null,c=s.some(u=>Math.abs(this.axes[u][a]-this.axes[u][a-1])>1e-6);if((l===null||l==="inserted")&&s.length===2&&c&&!this.isStart(a)){for(let u=0;u<o.length;u+=1)o[u]=this.axes[u][a];(Pp(t,o)??1)<ox&&(l="pole")}if(l===null)continue;let h=r.at(-1);h&&h.kind===l&&h.last===a-1?h.last=a:r.push({kind:l,first:a,last:a})}return r}};function Es(i,t){let e=0,n=i.length;for(;e<n;){let s=e+n>>>1;i[s]<t?e=s+1:n=s}return e}var aa="not drawn: a motion in machine coordinates (set `machine_zero` in the configuration)",Tl=class{constructor(t){this.program=t;this.lines=t.head.path.undrawn}program;lines;has(t){return this.lines[Es(this.lines,t)]===t}before(t){let{line:e}=this.program;if(!this.program.isStart(t))return[];let n=t===0?0:e[t-1];return this.lines.slice(Es(this.lines,n+1),Es(this.lines,e[t]))}};function El(i){let t=i.slice(0,12).join(", ");return`${i.length===1?"line":"lines"} ${t}${i.length>12?` and ${i.length-12} more`:""}`}function L(i,t={},...e){let n=document.createElement(i);for(let[s,r]of Object.entries(t))r===!0?n.setAttribute(s,""):r!==!1&&n.setAttribute(s,String(r));return n.append(...e),n}function dn(i){let t=L("button",{type:"button"},i.icon??i.label);return i.icon&&t.setAttribute("aria-label",i.label),i.icon&&t.classList.add("icon"),i.id&&(t.id=i.id),t.title=i.key?`${i.label} (${i.key})`:i.label,t.addEventListener("click",i.press),t}function ls(i){let t="http://www.w3.org/2000/svg",e=document.createElementNS(t,"svg");e.setAttribute("viewBox","0 0 20 20"),e.setAttribute("aria-hidden","true");let n=document.createElementNS(t,"path");return n.setAttribute("d",i),e.append(n),e}function ii(i,...t){i.replaceChildren(...t)}var Al=class{commands=new Map;dialog;constructor(t){let e={title:"Help",commands:[{keys:["?"],label:"this list",run:()=>this.toggleHelp()}]};for(let n of[...t,e].flatMap(s=>s.commands))for(let s of n.keys)this.commands.set(s,n);this.dialog=dx([...t,e]),document.body.append(this.dialog),document.addEventListener("keydown",n=>this.press(n))}toggleHelp(){this.dialog.open?this.dialog.close():this.dialog.showModal()}press(t){if(t.ctrlKey||t.metaKey||t.altKey||t.defaultPrevented)return;let e=t.target;if(e.closest("input[type=search], textarea")||e.closest("select")&&t.key!=="?"&&t.key!=="Escape"||e.closest("input")&&/^(Arrow|Home|End|Page| )/.test(t.key)||e.closest("button, summary, a")&&(t.key===" "||t.key==="Enter")||this.dialog.open&&t.key!=="?")return;let n=/^[a-z]$/i.test(t.key),s=t.key.length===1&&!n?t.key:`${t.shiftKey?"Shift+":""}${n?t.key.toLowerCase():t.key}`,r=this.commands.get(s);r&&(t.preventDefault(),r.run())}};function dx(i){let t=L("dialog",{id:"help-dialog","aria-label":"Keys"}),e=dn({label:"Close",press:()=>t.close()});e.autofocus=!0;let n=i.map(r=>L("section",{},L("h3",{},r.title),L("dl",{},...r.commands.flatMap(o=>[L("dt",{},...(o.shown??o.keys.map(px).join(" ")).split(" ").map(a=>L("kbd",{},a))),L("dd",{},o.label)])))),s=L("p",{class:"note"},"Pointer: drag to orbit, right button or two fingers to pan, wheel or pinch to zoom, click a line of the path to go there. In plots: drag to zoom, Shift and wheel to zoom, click to go there.");return t.append(L("header",{},L("h2",{},"Keys"),e),L("div",{class:"columns"},...n),s),t.addEventListener("click",r=>{r.target===t&&t.close()}),t}var fx={" ":"Space",ArrowLeft:"\u2190",ArrowRight:"\u2192",ArrowUp:"\u2191",ArrowDown:"\u2193"},px=i=>i.split(/(?<=Shift)\+/).map(t=>fx[t]??(t.length===1?t.toUpperCase():t)).join("+");var la=class{constructor(t,e,n,s,r){this.program=t;this.programText=e;this.clText=n;this.undrawn=s;this.short=r;this.root=L("div",{class:r?"block-card short":"block-card"})}program;programText;clText;undrawn;short;root;show(t){let{program:e}=this,n=e.line[t],s=[],r=this.clText?.line(e.clLine[t]).trim();e.clLine[t]>0&&s.push(["CL line",r?mx(String(e.clLine[t]),r):String(e.clLine[t])]);let o=e.reasonText(t);o!==null&&s.push(["Why",o]);let a=e.isStart(t)?"first known position":e.kindText(t),l=this.undrawn.before(t),c=e.isRapid(t)||e.isStart(t)?"":`, ${xe(e.feed[t])} mm/min`;if(s.push(["Motion",a+c]),l.length>0&&s.push(["Before",`${El(l)} ${aa}`]),this.short){let u=e.head.machine.joints.map((d,f)=>`${d.letter} ${He(e.axes[f][t],3)}${d.rotary?"\xB0":""}`);s.push(["Axes",u.join("  ")])}else{let u=e.head.operations[e.operation[t]];u&&s.push(["Operation",`${u.number}. ${u.name}${u.mode?` (${u.mode})`:""}`]);let d=e.head.machine.joints.flatMap((f,m)=>{let v=e.speeds[m][t];return Number.isFinite(v)&&v>.05?[`${f.letter} ${xe(v)} ${Gi(f)}/min`]:[]});d.length>0&&s.push(["Axis speeds",d.join("  ")]),e.head.set_ups.length>1&&s.push(["Set-up",e.setUpAt(t).name]),s.push(["Time",ni(e.countedS[t])])}Number.isFinite(e.errorUm[t])?s.push(["Path error",`${xe(e.errorUm[t])} \xB5m of ${xe(e.head.tolerance_mm*1e3)}`]):e.isNotCompared(t)&&s.push(["Path error","not compared"]);let h=L("dl",{class:"facts"});for(let[u,d]of s)h.append(L("dt",{},u),L("dd",{},d));this.fill(n,h)}showLine(t){let e=L("dl",{class:"facts"});e.append(L("dt",{},"Motion"),L("dd",{},this.undrawn.has(t)?aa:"none; the position is the last one before this line")),this.fill(t,e)}fill(t,e){for(let n of this.program.head.findings)t<n.line||t>n.last_line||e.append(L("dt",{class:"bad"},"Finding"),L("dd",{},n.text));ii(this.root,L("div",{class:"block-text"},L("span",{class:"line-number"},String(t)),L("code",{},this.programText.line(t)||"(empty line)")),e)}};function mx(i,t){let e=document.createDocumentFragment();return e.append(`${i}  `,L("code",{},t)),e}var Cl=class{constructor(t,e,n,s){this.stage=e;for(let r of t)this.select.append(L("option",{value:r.name},r.label));this.select.addEventListener("change",()=>n.colour(this.select.value)),this.root.append(L("h2",{},"Path"),gx("Colour",this.select),this.legend,s?L("p",{class:"note"},"In rapids each axis moves on its own: their path is not the line drawn."):"",this.choice("Shown (H)","extent",[["whole","all"],["done","done"],["operation","operation"]],()=>e.extent,r=>e.setExtent(r)),L("h2",{},"Machine"),this.choice("At rest (B)","fixed",[["machine","machine"],["part","part"]],()=>e.fixed,n.hold),this.choice("Bodies (M)","style",[["solid","solid"],["ghost","clear"],["off","off"]],()=>e.machineStyle,r=>e.setMachineStyle(r)),L("h2",{},"Layers"),this.layerList),e.layers.onChange(()=>this.updateLayers()),this.updateLayers()}stage;root=L("section",{class:"panel","aria-label":"Display"});select=L("select",{id:"colouring","aria-label":"Colour of the path",title:"Colour of the path (C)"});legend=L("div",{class:"legend"});layerList=L("div",{class:"layers"});choices=[];update(){for(let t of this.choices)t.update()}showColouring(t,e){this.select.value=t.name;let n=t.legend(e);if("entries"in n){let c=n.entries.map(h=>{let u=L("span",{class:h.dashed?"sample dashed":"sample"});return u.style.setProperty("--sample",h.colour),L("li",{},u,h.label)});ii(this.legend,L("ul",{},...c));return}let{scale:s}=n,r=t.table(e),o=Array.from({length:17},(c,h)=>Vn(r[Math.round(h/16*(r.length-1))])),a=L("div",{class:"scale"});if(a.style.background=`linear-gradient(to right, ${o.join(", ")})`,s.mark&&s.max>s.min){let c=(s.mark.value-s.min)/(s.max-s.min);if(c>=0&&c<=1){let h=L("span",{class:"scale-mark",title:`${s.mark.label} ${eo(s.mark.value,s.unit)}`});h.style.left=`${(100*c).toFixed(1)}%`,a.append(h)}}let l=(s.min+s.max)/2;ii(this.legend,a,L("div",{class:"scale-numbers"},L("span",{},eo(s.min,s.unit)),L("span",{},eo(l,s.unit)),L("span",{},`${s.beyond?"\u2265 ":""}${eo(s.max,s.unit)}`)),s.mark?L("p",{class:"note"},`${s.mark.label} ${eo(s.mark.value,s.unit)}`):"",L("p",{class:"note"},L("span",{class:"sample unknown"}),"no value"))}updateLayers(){let t=document.activeElement instanceof HTMLElement?document.activeElement.dataset.layer:void 0;ii(this.layerList,...this.stage.layers.list.map(e=>{let n=L("input",{type:"checkbox","data-layer":e.name});n.checked=e.visible,n.addEventListener("change",()=>this.stage.layers.set(e.name,n.checked));let s=L("span",{class:"sample-place"},e.sample?L("span",{class:e.sample}):"");return L("label",{},n,s,e.label,e.key?L("kbd",{},e.key):"")})),t&&this.layerList.querySelector(`[data-layer="${t}"]`)?.focus()}choice(t,e,n,s,r){let o=n.map(([l,c])=>{let h=L("input",{type:"radio",name:e,value:l});return h.addEventListener("change",()=>r(l)),{input:h,value:l,node:L("label",{},h,L("span",{},c))}}),a=()=>{for(let{input:l,value:c}of o)l.checked=c===s()};return a(),this.choices.push({update:a}),L("fieldset",{class:"choice"},L("legend",{},t),L("div",{},...o.map(l=>l.node)))}},gx=(i,t)=>L("label",{class:"labelled"},L("span",{},i),t);var lr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},cr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},hm=0,Sd=1,um=2;var Ga=1,dm=2,Io=3,hr=0,oi=1,Ai=2,Er=0,Do=1,Md=2,wd=3,Td=4,fm=5;var Ar=100,pm=101,mm=102,gm=103,_m=104,xm=200,ym=201,vm=202,bm=203,Ed=204,Ad=205,Sm=206,Mm=207,wm=208,Tm=209,Em=210,Am=211,Cm=212,Rm=213,Pm=214,rc=0,oc=1,ac=2,So=3,lc=4,cc=5,hc=6,uc=7,kc=0,Lm=1,Im=2,ds=0,Cd=1,Rd=2,Pd=3,Ld=4,Id=5,Dd=6,Nd=7;var Fd=300,Cr=301,No=302,zc=303,Vc=304,dc=1e3,hs=1001,fc=1002,On=1003,Dm=1004;var Ha=1005;var ri=1006,Gc=1007;var Os=1008;var fi=1009,Ud=1010,Od=1011,Fo=1012,Hc=1013,Yi=1014,Zi=1015,Ki=1016,Wc=1017,Xc=1018,Rr=1020,Bd=35902,kd=35899,zd=1021,Vd=1022,ji=1023,Ns=1026,Bs=1027,Gd=1028,qc=1029,ur=1030,$c=1031;var Yc=1033,Wa=33776,Xa=33777,qa=33778,$a=33779,Zc=35840,Kc=35841,jc=35842,Jc=35843,Qc=36196,th=37492,eh=37496,nh=37488,ih=37489,Ya=37490,sh=37491,rh=37808,oh=37809,ah=37810,lh=37811,ch=37812,hh=37813,uh=37814,dh=37815,fh=37816,ph=37817,mh=37818,gh=37819,_h=37820,xh=37821,yh=36492,vh=36494,bh=36495,Sh=36283,Mh=36284,Za=36285,wh=36286;var ga=2300,pc=2301,ic=2302,pd=2303,md=2400,gd=2401,_d=2402;var Nm=3200;var Th=0,Fm=1,ks="",bi="srgb",_a="srgb-linear",xa="linear",Le="srgb";var sc=7680;var Um=519,Om=512,Bm=513,km=514,Hd=515,zm=516,Vm=517,Wd=518,Xd=519,qd=35044;var zs="300 es",Ni=2e3,Mo=2001;function _x(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function xx(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function ya(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Gm(){let i=ya("canvas");return i.style.display="block",i}var Lp={},wo=null;function va(...i){let t="THREE."+i.shift();wo?wo("log",t,...i):console.log(t,...i)}function Hm(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function $t(...i){i=Hm(i);let t="THREE."+i.shift();if(wo)wo("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function ee(...i){i=Hm(i);let t="THREE."+i.shift();if(wo)wo("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function pa(...i){let t=i.join(" ");t in Lp||(Lp[t]=!0,$t(...i))}function Wm(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var Xm={[rc]:rc,[ac]:hc,[lc]:lc,[So]:cc,[oc]:oc,[hc]:ac,[uc]:uc,[cc]:So},qi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Yn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Ip=1234567,vo=Math.PI/180,To=180/Math.PI;function dr(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Yn[i&255]+Yn[i>>8&255]+Yn[i>>16&255]+Yn[i>>24&255]+"-"+Yn[t&255]+Yn[t>>8&255]+"-"+Yn[t>>16&15|64]+Yn[t>>24&255]+"-"+Yn[e&63|128]+Yn[e>>8&255]+"-"+Yn[e>>16&255]+Yn[e>>24&255]+Yn[n&255]+Yn[n>>8&255]+Yn[n>>16&255]+Yn[n>>24&255]).toLowerCase()}function re(i,t,e){return Math.max(t,Math.min(e,i))}function $d(i,t){return(i%t+t)%t}function yx(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function vx(i,t,e){return i!==t?(e-i)/(t-i):0}function ma(i,t,e){return(1-e)*i+e*t}function bx(i,t,e,n){return ma(i,t,1-Math.exp(-e*n))}function Sx(i,t=1){return t-Math.abs($d(i,t*2)-t)}function Mx(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function wx(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function Tx(i,t){return i+Math.floor(Math.random()*(t-i+1))}function Ex(i,t){return i+Math.random()*(t-i)}function Ax(i){return i*(.5-Math.random())}function Cx(i){i!==void 0&&(Ip=i);let t=Ip+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Rx(i){return i*vo}function Px(i){return i*To}function Lx(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function Ix(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Yd(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Dx(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),h=o((t+n)/2),u=r((t-n)/2),d=o((t-n)/2),f=r((n-t)/2),m=o((n-t)/2);switch(s){case"XYX":i.set(a*h,l*u,l*d,a*c);break;case"YZY":i.set(l*d,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*d,a*h,a*c);break;case"XZX":i.set(a*h,l*m,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*m,a*c);break;case"ZYZ":i.set(l*m,l*f,a*h,a*c);break;default:$t("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Eh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Zd(i,t){if(t.constructor===Float32Array)return i;let e=Eh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function Kd(i,t){if(t.constructor===Float32Array)return i;let e=Eh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var Ka={DEG2RAD:vo,RAD2DEG:To,generateUUID:dr,clamp:re,euclideanModulo:$d,mapLinear:yx,inverseLerp:vx,lerp:ma,damp:bx,pingpong:Sx,smoothstep:Mx,smootherstep:wx,randInt:Tx,randFloat:Ex,randFloatSpread:Ax,seededRandom:Cx,degToRad:Rx,radToDeg:Px,isPowerOfTwo:Lx,ceilPowerOfTwo:Ix,floorPowerOfTwo:Yd,setQuaternionFromProperEuler:Dx,normalize:Kd,denormalize:Zd},Xt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=re(this.x,t.x,e.x),this.y=re(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=re(this.x,t,e),this.y=re(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(re(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(re(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Gn=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],m=r[o+2],v=r[o+3];if(u!==v||l!==d||c!==f||h!==m){let g=l*d+c*f+h*m+u*v;g<0&&(d=-d,f=-f,m=-m,v=-v,g=-g);let p=1-a;if(g<.9995){let y=Math.acos(g),M=Math.sin(y);p=Math.sin(p*y)/M,a=Math.sin(a*y)/M,l=l*p+d*a,c=c*p+f*a,h=h*p+m*a,u=u*p+v*a}else{l=l*p+d*a,c=c*p+f*a,h=h*p+m*a,u=u*p+v*a;let y=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=y,c*=y,h*=y,u*=y}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],m=r[o+3];return t[e]=a*m+h*u+l*f-c*d,t[e+1]=l*m+h*d+c*u-a*f,t[e+2]=c*m+h*f+a*d-l*u,t[e+3]=h*m-a*u-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),f=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*m,this._y=c*f*u-d*h*m,this._z=c*h*m+d*f*u,this._w=c*h*u-d*f*m;break;case"YXZ":this._x=d*h*u+c*f*m,this._y=c*f*u-d*h*m,this._z=c*h*m-d*f*u,this._w=c*h*u+d*f*m;break;case"ZXY":this._x=d*h*u-c*f*m,this._y=c*f*u+d*h*m,this._z=c*h*m+d*f*u,this._w=c*h*u-d*f*m;break;case"ZYX":this._x=d*h*u-c*f*m,this._y=c*f*u+d*h*m,this._z=c*h*m-d*f*u,this._w=c*h*u+d*f*m;break;case"YZX":this._x=d*h*u+c*f*m,this._y=c*f*u+d*h*m,this._z=c*h*m-d*f*u,this._w=c*h*u-d*f*m;break;case"XZY":this._x=d*h*u-c*f*m,this._y=c*f*u-d*h*m,this._z=c*h*m+d*f*u,this._w=c*h*u+d*f*m;break;default:$t("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(re(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},O=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Dp.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Dp.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),u=2*(r*n-o*e);return this.x=e+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=re(this.x,t.x,e.x),this.y=re(this.y,t.y,e.y),this.z=re(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=re(this.x,t,e),this.y=re(this.y,t,e),this.z=re(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(re(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return Xu.copy(this).projectOnVector(t),this.sub(Xu)}reflect(t){return this.sub(Xu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(re(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Xu=new O,Dp=new Gn,ne=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],m=n[8],v=s[0],g=s[3],p=s[6],y=s[1],M=s[4],b=s[7],C=s[2],A=s[5],_=s[8];return r[0]=o*v+a*y+l*C,r[3]=o*g+a*M+l*A,r[6]=o*p+a*b+l*_,r[1]=c*v+h*y+u*C,r[4]=c*g+h*M+u*A,r[7]=c*p+h*b+u*_,r[2]=d*v+f*y+m*C,r[5]=d*g+f*M+m*A,r[8]=d*p+f*b+m*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,m=e*u+n*d+s*f;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/m;return t[0]=u*v,t[1]=(s*c-h*n)*v,t[2]=(a*n-s*o)*v,t[3]=d*v,t[4]=(h*e-s*l)*v,t[5]=(s*r-a*e)*v,t[6]=f*v,t[7]=(n*l-c*e)*v,t[8]=(o*e-n*r)*v,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return pa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(qu.makeScale(t,e)),this}rotate(t){return pa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(qu.makeRotation(-t)),this}translate(t,e){return pa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(qu.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},qu=new ne,Np=new ne().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Fp=new ne().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Nx(){let i={enabled:!0,workingColorSpace:_a,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Le&&(s.r=Ds(s.r),s.g=Ds(s.g),s.b=Ds(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Le&&(s.r=bo(s.r),s.g=bo(s.g),s.b=bo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ks?xa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[_a]:{primaries:t,whitePoint:n,transfer:xa,toXYZ:Np,fromXYZ:Fp,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:bi},outputColorSpaceConfig:{drawingBufferColorSpace:bi}},[bi]:{primaries:t,whitePoint:n,transfer:Le,toXYZ:Np,fromXYZ:Fp,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:bi}}}),i}var ye=Nx();function Ds(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function bo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var so,mc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{so===void 0&&(so=ya("canvas")),so.width=t.width,so.height=t.height;let s=so.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=so}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=ya("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ds(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Ds(e[n]/255)*255):e[n]=Ds(e[n]);return{data:e,width:t.width,height:t.height}}else return $t("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Fx=0,Eo=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Fx++}),this.uuid=dr(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push($u(s[o].image)):r.push($u(s[o]))}else r=$u(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function $u(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?mc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:($t("Texture: Unable to serialize Texture."),{})}var Ux=0,Yu=new O,hi=class i extends qi{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=hs,s=hs,r=ri,o=Os,a=ji,l=fi,c=i.DEFAULT_ANISOTROPY,h=ks){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Ux++}),this.uuid=dr(),this.name="",this.source=new Eo(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Xt(0,0),this.repeat=new Xt(1,1),this.center=new Xt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ne,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Yu).x}get height(){return this.source.getSize(Yu).y}get depth(){return this.source.getSize(Yu).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){$t(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){$t(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Fd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case dc:t.x=t.x-Math.floor(t.x);break;case hs:t.x=t.x<0?0:1;break;case fc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case dc:t.y=t.y-Math.floor(t.y);break;case hs:t.y=t.y<0?0:1;break;case fc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};hi.DEFAULT_IMAGE=null;hi.DEFAULT_MAPPING=Fd;hi.DEFAULT_ANISOTROPY=1;var Ie=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],m=l[9],v=l[2],g=l[6],p=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-v)<.01&&Math.abs(m-g)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+v)<.1&&Math.abs(m+g)<.1&&Math.abs(c+f+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let M=(c+1)/2,b=(f+1)/2,C=(p+1)/2,A=(h+d)/4,_=(u+v)/4,w=(m+g)/4;return M>b&&M>C?M<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(M),s=A/n,r=_/n):b>C?b<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=A/s,r=w/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=_/r,s=w/r),this.set(n,s,r,e),this}let y=Math.sqrt((g-m)*(g-m)+(u-v)*(u-v)+(d-h)*(d-h));return Math.abs(y)<.001&&(y=1),this.x=(g-m)/y,this.y=(u-v)/y,this.z=(d-h)/y,this.w=Math.acos((c+f+p-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=re(this.x,t.x,e.x),this.y=re(this.y,t.y,e.y),this.z=re(this.z,t.z,e.z),this.w=re(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=re(this.x,t,e),this.y=re(this.y,t,e),this.z=re(this.z,t,e),this.w=re(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(re(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},gc=class extends qi{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ri,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new Ie(0,0,t,e),this.scissorTest=!1,this.viewport=new Ie(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new hi({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:ri,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Eo(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},wi=class extends gc{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},ba=class extends hi{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=On,this.minFilter=On,this.wrapR=hs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var _c=class extends hi{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=On,this.minFilter=On,this.wrapR=hs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var be=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,l,c,h,u,d,f,m,v,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,u,d,f,m,v,g)}set(t,e,n,s,r,o,a,l,c,h,u,d,f,m,v,g){let p=this.elements;return p[0]=t,p[4]=e,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=h,p[10]=u,p[14]=d,p[3]=f,p[7]=m,p[11]=v,p[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/ro.setFromMatrixColumn(t,0).length(),r=1/ro.setFromMatrixColumn(t,1).length(),o=1/ro.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let d=o*h,f=o*u,m=a*h,v=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=f+m*c,e[5]=d-v*c,e[9]=-a*l,e[2]=v-d*c,e[6]=m+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*h,f=l*u,m=c*h,v=c*u;e[0]=d+v*a,e[4]=m*a-f,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=f*a-m,e[6]=v+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*h,f=l*u,m=c*h,v=c*u;e[0]=d-v*a,e[4]=-o*u,e[8]=m+f*a,e[1]=f+m*a,e[5]=o*h,e[9]=v-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*h,f=o*u,m=a*h,v=a*u;e[0]=l*h,e[4]=m*c-f,e[8]=d*c+v,e[1]=l*u,e[5]=v*c+d,e[9]=f*c-m,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,m=a*l,v=a*c;e[0]=l*h,e[4]=v-d*u,e[8]=m*u+f,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=f*u+m,e[10]=d-v*u}else if(t.order==="XZY"){let d=o*l,f=o*c,m=a*l,v=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=d*u+v,e[5]=o*h,e[9]=f*u-m,e[2]=m*u-f,e[6]=a*h,e[10]=v*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Ox,t,Bx)}lookAt(t,e,n){let s=this.elements;return yi.subVectors(t,e),yi.lengthSq()===0&&(yi.z=1),yi.normalize(),Ks.crossVectors(n,yi),Ks.lengthSq()===0&&(Math.abs(n.z)===1?yi.x+=1e-4:yi.z+=1e-4,yi.normalize(),Ks.crossVectors(n,yi)),Ks.normalize(),Rl.crossVectors(yi,Ks),s[0]=Ks.x,s[4]=Rl.x,s[8]=yi.x,s[1]=Ks.y,s[5]=Rl.y,s[9]=yi.y,s[2]=Ks.z,s[6]=Rl.z,s[10]=yi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],m=n[2],v=n[6],g=n[10],p=n[14],y=n[3],M=n[7],b=n[11],C=n[15],A=s[0],_=s[4],w=s[8],U=s[12],F=s[1],I=s[5],V=s[9],H=s[13],N=s[2],X=s[6],Y=s[10],W=s[14],ct=s[3],j=s[7],Q=s[11],st=s[15];return r[0]=o*A+a*F+l*N+c*ct,r[4]=o*_+a*I+l*X+c*j,r[8]=o*w+a*V+l*Y+c*Q,r[12]=o*U+a*H+l*W+c*st,r[1]=h*A+u*F+d*N+f*ct,r[5]=h*_+u*I+d*X+f*j,r[9]=h*w+u*V+d*Y+f*Q,r[13]=h*U+u*H+d*W+f*st,r[2]=m*A+v*F+g*N+p*ct,r[6]=m*_+v*I+g*X+p*j,r[10]=m*w+v*V+g*Y+p*Q,r[14]=m*U+v*H+g*W+p*st,r[3]=y*A+M*F+b*N+C*ct,r[7]=y*_+M*I+b*X+C*j,r[11]=y*w+M*V+b*Y+C*Q,r[15]=y*U+M*H+b*W+C*st,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],d=t[10],f=t[14],m=t[3],v=t[7],g=t[11],p=t[15],y=l*f-c*d,M=a*f-c*u,b=a*d-l*u,C=o*f-c*h,A=o*d-l*h,_=o*u-a*h;return e*(v*y-g*M+p*b)-n*(m*y-g*C+p*A)+s*(m*M-v*C+p*_)-r*(m*b-v*A+g*_)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],d=t[10],f=t[11],m=t[12],v=t[13],g=t[14],p=t[15],y=e*a-n*o,M=e*l-s*o,b=e*c-r*o,C=n*l-s*a,A=n*c-r*a,_=s*c-r*l,w=h*v-u*m,U=h*g-d*m,F=h*p-f*m,I=u*g-d*v,V=u*p-f*v,H=d*p-f*g,N=y*H-M*V+b*I+C*F-A*U+_*w;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let X=1/N;return t[0]=(a*H-l*V+c*I)*X,t[1]=(s*V-n*H-r*I)*X,t[2]=(v*_-g*A+p*C)*X,t[3]=(d*A-u*_-f*C)*X,t[4]=(l*F-o*H-c*U)*X,t[5]=(e*H-s*F+r*U)*X,t[6]=(g*b-m*_-p*M)*X,t[7]=(h*_-d*b+f*M)*X,t[8]=(o*V-a*F+c*w)*X,t[9]=(n*F-e*V-r*w)*X,t[10]=(m*A-v*b+p*y)*X,t[11]=(u*b-h*A-f*y)*X,t[12]=(a*U-o*I-l*w)*X,t[13]=(e*I-n*U+s*w)*X,t[14]=(v*M-m*C-g*y)*X,t[15]=(h*C-u*M+d*y)*X,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,m=r*u,v=o*h,g=o*u,p=a*u,y=l*c,M=l*h,b=l*u,C=n.x,A=n.y,_=n.z;return s[0]=(1-(v+p))*C,s[1]=(f+b)*C,s[2]=(m-M)*C,s[3]=0,s[4]=(f-b)*A,s[5]=(1-(d+p))*A,s[6]=(g+y)*A,s[7]=0,s[8]=(m+M)*_,s[9]=(g-y)*_,s[10]=(1-(d+v))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=ro.set(s[0],s[1],s[2]).length(),a=ro.set(s[4],s[5],s[6]).length(),l=ro.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Hi.copy(this);let c=1/o,h=1/a,u=1/l;return Hi.elements[0]*=c,Hi.elements[1]*=c,Hi.elements[2]*=c,Hi.elements[4]*=h,Hi.elements[5]*=h,Hi.elements[6]*=h,Hi.elements[8]*=u,Hi.elements[9]*=u,Hi.elements[10]*=u,e.setFromRotationMatrix(Hi),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,s,r,o,a=Ni,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(n-s),d=(e+t)/(e-t),f=(n+s)/(n-s),m,v;if(l)m=r/(o-r),v=o*r/(o-r);else if(a===Ni)m=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===Mo)m=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=Ni,l=!1){let c=this.elements,h=2/(e-t),u=2/(n-s),d=-(e+t)/(e-t),f=-(n+s)/(n-s),m,v;if(l)m=1/(o-r),v=o/(o-r);else if(a===Ni)m=-2/(o-r),v=-(o+r)/(o-r);else if(a===Mo)m=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=m,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},ro=new O,Hi=new be,Ox=new O(0,0,0),Bx=new O(1,1,1),Ks=new O,Rl=new O,yi=new O,Up=new be,Op=new Gn,Fs=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(re(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-re(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(re(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-re(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(re(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-re(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:$t("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return Up.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Up,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Op.setFromEuler(this),this.setFromQuaternion(Op,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Fs.DEFAULT_ORDER="XYZ";var Sa=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},kx=0,Bp=new O,oo=new Gn,As=new be,Pl=new O,ca=new O,zx=new O,Vx=new Gn,kp=new O(1,0,0),zp=new O(0,1,0),Vp=new O(0,0,1),Gp={type:"added"},Gx={type:"removed"},ao={type:"childadded",child:null},Zu={type:"childremoved",child:null},Bn=class i extends qi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:kx++}),this.uuid=dr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new O,e=new Fs,n=new Gn,s=new O(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new be},normalMatrix:{value:new ne}}),this.matrix=new be,this.matrixWorld=new be,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Sa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return oo.setFromAxisAngle(t,e),this.quaternion.multiply(oo),this}rotateOnWorldAxis(t,e){return oo.setFromAxisAngle(t,e),this.quaternion.premultiply(oo),this}rotateX(t){return this.rotateOnAxis(kp,t)}rotateY(t){return this.rotateOnAxis(zp,t)}rotateZ(t){return this.rotateOnAxis(Vp,t)}translateOnAxis(t,e){return Bp.copy(t).applyQuaternion(this.quaternion),this.position.add(Bp.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(kp,t)}translateY(t){return this.translateOnAxis(zp,t)}translateZ(t){return this.translateOnAxis(Vp,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(As.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Pl.copy(t):Pl.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),ca.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?As.lookAt(ca,Pl,this.up):As.lookAt(Pl,ca,this.up),this.quaternion.setFromRotationMatrix(As),s&&(As.extractRotation(s.matrixWorld),oo.setFromRotationMatrix(As),this.quaternion.premultiply(oo.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ee("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Gp),ao.child=t,this.dispatchEvent(ao),ao.child=null):ee("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Gx),Zu.child=t,this.dispatchEvent(Zu),Zu.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),As.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),As.multiply(t.parent.matrixWorld)),t.applyMatrix4(As),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Gp),ao.child=t,this.dispatchEvent(ao),ao.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ca,t,zx),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ca,Vx,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),d=o(t.skeletons),f=o(t.animations),m=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),m.length>0&&(n.nodes=m)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Bn.DEFAULT_UP=new O(0,1,0);Bn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Bn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var fn=class extends Bn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Hx={type:"move"},Ao=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new fn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new fn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new O,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new O),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new fn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new O,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new O,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let v of t.hand.values()){let g=e.getJointPose(v,n),p=this._getHandJoint(c,v);g!==null&&(p.matrix.fromArray(g.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=g.radius),p.visible=g!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,m=.005;c.inputState.pinching&&d>f+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Hx)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new fn;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},qm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},js={h:0,s:0,l:0},Ll={h:0,s:0,l:0};function Ku(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var Zt=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=bi){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ye.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=ye.workingColorSpace){return this.r=t,this.g=e,this.b=n,ye.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=ye.workingColorSpace){if(t=$d(t,1),e=re(e,0,1),n=re(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=Ku(o,r,t+1/3),this.g=Ku(o,r,t),this.b=Ku(o,r,t-1/3)}return ye.colorSpaceToWorking(this,s),this}setStyle(t,e=bi){function n(r){r!==void 0&&parseFloat(r)<1&&$t("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:$t("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);$t("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=bi){let n=qm[t.toLowerCase()];return n!==void 0?this.setHex(n,e):$t("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Ds(t.r),this.g=Ds(t.g),this.b=Ds(t.b),this}copyLinearToSRGB(t){return this.r=bo(t.r),this.g=bo(t.g),this.b=bo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=bi){return ye.workingToColorSpace(Zn.copy(this),t),Math.round(re(Zn.r*255,0,255))*65536+Math.round(re(Zn.g*255,0,255))*256+Math.round(re(Zn.b*255,0,255))}getHexString(t=bi){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ye.workingColorSpace){ye.workingToColorSpace(Zn.copy(this),e);let n=Zn.r,s=Zn.g,r=Zn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=ye.workingColorSpace){return ye.workingToColorSpace(Zn.copy(this),e),t.r=Zn.r,t.g=Zn.g,t.b=Zn.b,t}getStyle(t=bi){ye.workingToColorSpace(Zn.copy(this),t);let e=Zn.r,n=Zn.g,s=Zn.b;return t!==bi?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(js),this.setHSL(js.h+t,js.s+e,js.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(js),t.getHSL(Ll);let n=ma(js.h,Ll.h,e),s=ma(js.s,Ll.s,e),r=ma(js.l,Ll.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Zn=new Zt;Zt.NAMES=qm;var Ma=class extends Bn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Fs,this.environmentIntensity=1,this.environmentRotation=new Fs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Wi=new O,Cs=new O,ju=new O,Rs=new O,lo=new O,co=new O,Hp=new O,Ju=new O,Qu=new O,td=new O,ed=new Ie,nd=new Ie,id=new Ie,Is=class i{constructor(t=new O,e=new O,n=new O){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Wi.subVectors(t,e),s.cross(Wi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Wi.subVectors(s,e),Cs.subVectors(n,e),ju.subVectors(t,e);let o=Wi.dot(Wi),a=Wi.dot(Cs),l=Wi.dot(ju),c=Cs.dot(Cs),h=Cs.dot(ju),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,m=(o*h-a*l)*d;return r.set(1-f-m,m,f)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,Rs)===null?!1:Rs.x>=0&&Rs.y>=0&&Rs.x+Rs.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,Rs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Rs.x),l.addScaledVector(o,Rs.y),l.addScaledVector(a,Rs.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return ed.setScalar(0),nd.setScalar(0),id.setScalar(0),ed.fromBufferAttribute(t,e),nd.fromBufferAttribute(t,n),id.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(ed,r.x),o.addScaledVector(nd,r.y),o.addScaledVector(id,r.z),o}static isFrontFacing(t,e,n,s){return Wi.subVectors(n,e),Cs.subVectors(t,e),Wi.cross(Cs).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Wi.subVectors(this.c,this.b),Cs.subVectors(this.a,this.b),Wi.cross(Cs).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;lo.subVectors(s,n),co.subVectors(r,n),Ju.subVectors(t,n);let l=lo.dot(Ju),c=co.dot(Ju);if(l<=0&&c<=0)return e.copy(n);Qu.subVectors(t,s);let h=lo.dot(Qu),u=co.dot(Qu);if(h>=0&&u<=h)return e.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(n).addScaledVector(lo,o);td.subVectors(t,r);let f=lo.dot(td),m=co.dot(td);if(m>=0&&f<=m)return e.copy(r);let v=f*c-l*m;if(v<=0&&c>=0&&m<=0)return a=c/(c-m),e.copy(n).addScaledVector(co,a);let g=h*m-f*u;if(g<=0&&u-h>=0&&f-m>=0)return Hp.subVectors(r,s),a=(u-h)/(u-h+(f-m)),e.copy(s).addScaledVector(Hp,a);let p=1/(g+v+d);return o=v*p,a=d*p,e.copy(n).addScaledVector(lo,o).addScaledVector(co,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},en=class{constructor(t=new O(1/0,1/0,1/0),e=new O(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Xi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Xi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Xi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Xi):Xi.fromBufferAttribute(r,o),Xi.applyMatrix4(t.matrixWorld),this.expandByPoint(Xi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Il.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Il.copy(n.boundingBox)),Il.applyMatrix4(t.matrixWorld),this.union(Il)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Xi),Xi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ha),Dl.subVectors(this.max,ha),ho.subVectors(t.a,ha),uo.subVectors(t.b,ha),fo.subVectors(t.c,ha),Js.subVectors(uo,ho),Qs.subVectors(fo,uo),yr.subVectors(ho,fo);let e=[0,-Js.z,Js.y,0,-Qs.z,Qs.y,0,-yr.z,yr.y,Js.z,0,-Js.x,Qs.z,0,-Qs.x,yr.z,0,-yr.x,-Js.y,Js.x,0,-Qs.y,Qs.x,0,-yr.y,yr.x,0];return!sd(e,ho,uo,fo,Dl)||(e=[1,0,0,0,1,0,0,0,1],!sd(e,ho,uo,fo,Dl))?!1:(Nl.crossVectors(Js,Qs),e=[Nl.x,Nl.y,Nl.z],sd(e,ho,uo,fo,Dl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Xi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Xi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Ps[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Ps[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Ps[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Ps[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Ps[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Ps[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Ps[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Ps[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Ps),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Ps=[new O,new O,new O,new O,new O,new O,new O,new O],Xi=new O,Il=new en,ho=new O,uo=new O,fo=new O,Js=new O,Qs=new O,yr=new O,ha=new O,Dl=new O,Nl=new O,vr=new O;function sd(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){vr.fromArray(i,r);let a=s.x*Math.abs(vr.x)+s.y*Math.abs(vr.y)+s.z*Math.abs(vr.z),l=t.dot(vr),c=e.dot(vr),h=n.dot(vr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var vn=new O,Fl=new Xt,Wx=0,we=class extends qi{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Wx++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=qd,this.updateRanges=[],this.gpuType=Zi,this.version=0,this._normalizationScale=t!==void 0?Eh(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Fl.fromBufferAttribute(this,e),Fl.applyMatrix3(t),this.setXY(e,Fl.x,Fl.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)vn.fromBufferAttribute(this,e),vn.applyMatrix3(t),this.setXYZ(e,vn.x,vn.y,vn.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)vn.fromBufferAttribute(this,e),vn.applyMatrix4(t),this.setXYZ(e,vn.x,vn.y,vn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)vn.fromBufferAttribute(this,e),vn.applyNormalMatrix(t),this.setXYZ(e,vn.x,vn.y,vn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)vn.fromBufferAttribute(this,e),vn.transformDirection(t),this.setXYZ(e,vn.x,vn.y,vn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Zd(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Kd(t,this.array)}};var wa=class extends we{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var Ta=class extends we{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Ze=class extends we{constructor(t,e,n){super(new Float32Array(t),e,n)}},Xx=new en,ua=new O,rd=new O,Fi=class{constructor(t=new O,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Xx.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;ua.subVectors(t,this.center);let e=ua.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(ua,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(rd.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(ua.copy(t.center).add(rd)),this.expandByPoint(ua.copy(t.center).sub(rd))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},qx=0,Di=new be,od=new Bn,po=new O,vi=new en,da=new en,Un=new O,Ee=class i extends qi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:qx++}),this.uuid=dr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(_x(t)?Ta:wa)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new ne().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Di.makeRotationFromQuaternion(t),this.applyMatrix4(Di),this}rotateX(t){return Di.makeRotationX(t),this.applyMatrix4(Di),this}rotateY(t){return Di.makeRotationY(t),this.applyMatrix4(Di),this}rotateZ(t){return Di.makeRotationZ(t),this.applyMatrix4(Di),this}translate(t,e,n){return Di.makeTranslation(t,e,n),this.applyMatrix4(Di),this}scale(t,e,n){return Di.makeScale(t,e,n),this.applyMatrix4(Di),this}lookAt(t){return od.lookAt(t),od.updateMatrix(),this.applyMatrix4(od.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(po).negate(),this.translate(po.x,po.y,po.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ze(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&$t("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new en);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ee("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new O(-1/0,-1/0,-1/0),new O(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];vi.setFromBufferAttribute(r),this.morphTargetsRelative?(Un.addVectors(this.boundingBox.min,vi.min),this.boundingBox.expandByPoint(Un),Un.addVectors(this.boundingBox.max,vi.max),this.boundingBox.expandByPoint(Un)):(this.boundingBox.expandByPoint(vi.min),this.boundingBox.expandByPoint(vi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ee('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Fi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ee("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new O,1/0);return}if(t){let n=this.boundingSphere.center;if(vi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];da.setFromBufferAttribute(a),this.morphTargetsRelative?(Un.addVectors(vi.min,da.min),vi.expandByPoint(Un),Un.addVectors(vi.max,da.max),vi.expandByPoint(Un)):(vi.expandByPoint(da.min),vi.expandByPoint(da.max))}vi.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Un.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Un));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Un.fromBufferAttribute(a,c),l&&(po.fromBufferAttribute(t,c),Un.add(po)),s=Math.max(s,n.distanceToSquared(Un))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ee('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ee("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new we(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let U=0;U<n.count;U++)a[U]=new O,l[U]=new O;let h=new O,u=new O,d=new O,f=new Xt,m=new Xt,v=new Xt,g=new O,p=new O;function y(U,F,I){c[U]=c[F]=c[I]=1,h.fromBufferAttribute(n,U),u.fromBufferAttribute(n,F),d.fromBufferAttribute(n,I),f.fromBufferAttribute(r,U),m.fromBufferAttribute(r,F),v.fromBufferAttribute(r,I),u.sub(h),d.sub(h),m.sub(f),v.sub(f);let V=1/(m.x*v.y-v.x*m.y);isFinite(V)&&(g.copy(u).multiplyScalar(v.y).addScaledVector(d,-m.y).multiplyScalar(V),p.copy(d).multiplyScalar(m.x).addScaledVector(u,-v.x).multiplyScalar(V),a[U].add(g),a[F].add(g),a[I].add(g),l[U].add(p),l[F].add(p),l[I].add(p))}let M=this.groups;M.length===0&&(M=[{start:0,count:t.count}]);for(let U=0,F=M.length;U<F;++U){let I=M[U],V=I.start,H=I.count;for(let N=V,X=V+H;N<X;N+=3)y(t.getX(N+0),t.getX(N+1),t.getX(N+2))}let b=new O,C=new O,A=new O,_=new O;function w(U){A.fromBufferAttribute(s,U),_.copy(A);let F=a[U];b.copy(F),b.sub(A.multiplyScalar(A.dot(F))).normalize(),C.crossVectors(_,F);let V=C.dot(l[U])<0?-1:1;o.setXYZW(U,b.x,b.y,b.z,V)}for(let U=0,F=n.count;U<F;++U)c[U]&&w(U);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new we(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new O,r=new O,o=new O,a=new O,l=new O,c=new O,h=new O,u=new O;if(t)for(let d=0,f=t.count;d<f;d+=3){let m=t.getX(d+0),v=t.getX(d+1),g=t.getX(d+2);s.fromBufferAttribute(e,m),r.fromBufferAttribute(e,v),o.fromBufferAttribute(e,g),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,m),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,g),a.add(h),l.add(h),c.add(h),n.setXYZ(m,a.x,a.y,a.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Un.fromBufferAttribute(t,e),Un.normalize(),t.setXYZ(e,Un.x,Un.y,Un.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,m=0;for(let v=0,g=l.length;v<g;v++){a.isInterleavedBufferAttribute?f=l[v]*a.data.stride+a.offset:f=l[v]*h;for(let p=0;p<h;p++)d[m++]=c[f++]}return new we(d,h,u)}if(this.index===null)return $t("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=t(d,n);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},xc=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=qd,this.updateRanges=[],this.version=0,this.uuid=dr()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,n){t*=this.stride,n*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[n+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Wp(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let n=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Wp(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function Wp(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=dr()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var si=new O,$i=class i{constructor(t,e,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=n,this.normalized=s,this._normalizationScale=t!==void 0?Eh(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,n=this.data.count;e<n;e++)si.fromBufferAttribute(this,e),si.applyMatrix4(t),this.setXYZ(e,si.x,si.y,si.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)si.fromBufferAttribute(this,e),si.applyNormalMatrix(t),this.setXYZ(e,si.x,si.y,si.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)si.fromBufferAttribute(this,e),si.transformDirection(t),this.setXYZ(e,si.x,si.y,si.z);return this}getComponent(t,e){let n=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.data.array[t*this.data.stride+this.offset+e]=n,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,n){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.data.array[t+0]=e,this.data.array[t+1]=n,this}setXYZ(t,e,n,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){va("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new we(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new i(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){va("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Zd(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Kd(t,this.data.array)}},ad=new O,$x=new O,Yx=new ne,Si=class{constructor(t=new O(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=ad.subVectors(n,e).cross($x.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(ad),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Yx.getNormalMatrix(t),s=this.coplanarPoint(ad).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Zx=0,us=class extends qi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Zx++}),this.uuid=dr(),this.name="",this.type="Material",this.blending=Do,this.side=hr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ed,this.blendDst=Ad,this.blendEquation=Ar,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Zt(0,0,0),this.blendAlpha=0,this.depthFunc=So,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Um,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=sc,this.stencilZFail=sc,this.stencilZPass=sc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){$t(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){$t(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Zt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new Si().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Xt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Xt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var Ls=new O,ld=new O,Ul=new O,Ol=new O,er=class{constructor(t=new O,e=new O(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Ls)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Ls.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Ls.copy(this.origin).addScaledVector(this.direction,e),Ls.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){ld.copy(t).add(e).multiplyScalar(.5),Ul.copy(e).sub(t).normalize(),Ol.copy(this.origin).sub(ld);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Ul),a=Ol.dot(this.direction),l=-Ol.dot(Ul),c=Ol.lengthSq(),h=Math.abs(1-o*o),u,d,f,m;if(h>0)if(u=o*l-a,d=o*a-l,m=r*h,u>=0)if(d>=-m)if(d<=m){let v=1/h;u*=v,d*=v,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-m?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=m?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(ld).addScaledVector(Ul,d),f}intersectSphere(t,e){if(t.radius<0)return null;Ls.subVectors(t.center,this.origin);let n=Ls.dot(this.direction),s=Ls.dot(Ls)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(n=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),h>=0?(r=(t.min.y-d.y)*h,o=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,o=(t.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-d.z)*u,l=(t.max.z-d.z)*u):(a=(t.max.z-d.z)*u,l=(t.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,Ls)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=t.x-o.x,d=t.y-o.y,f=t.z-o.z,m=e.x-o.x,v=e.y-o.y,g=e.z-o.z,p=n.x-o.x,y=n.y-o.y,M=n.z-o.z,b=Math.abs(l),C=Math.abs(c),A=Math.abs(h),_,w,U,F,I,V,H,N,X,Y,W,ct;if(b>=C&&b>=A?(U=l,V=u,X=m,ct=p,l>=0?(_=c,w=h,F=d,I=f,H=v,N=g,Y=y,W=M):(_=h,w=c,F=f,I=d,H=g,N=v,Y=M,W=y)):C>=A?(U=c,V=d,X=v,ct=y,c>=0?(_=h,w=l,F=f,I=u,H=g,N=m,Y=M,W=p):(_=l,w=h,F=u,I=f,H=m,N=g,Y=p,W=M)):(U=h,V=f,X=g,ct=M,h>=0?(_=l,w=c,F=u,I=d,H=m,N=v,Y=p,W=y):(_=c,w=l,F=d,I=u,H=v,N=m,Y=y,W=p)),U===0)return null;let j=_/U,Q=w/U,st=1/U,dt=F-j*V,ut=I-Q*V,tt=H-j*X,mt=N-Q*X,xt=Y-j*ct,At=W-Q*ct,St=xt*mt-At*tt,Ht=dt*At-ut*xt,oe=tt*ut-mt*dt;if(s){if(St<0||Ht<0||oe<0)return null}else if((St<0||Ht<0||oe<0)&&(St>0||Ht>0||oe>0))return null;let Vt=St+Ht+oe;if(Vt===0)return null;let fe=st*(St*V+Ht*X+oe*ct);return(Vt>0?fe<0:fe>0)?null:this.at(fe/Vt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Co=class extends us{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Zt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Fs,this.combine=kc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Xp=new be,br=new er,Bl=new Fi,qp=new O,kl=new O,zl=new O,Vl=new O,cd=new O,Gl=new O,$p=new O,Hl=new O,Ke=class extends Bn{constructor(t=new Ee,e=new Co){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Gl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(cd.fromBufferAttribute(u,t),o?Gl.addScaledVector(cd,h):Gl.addScaledVector(cd.sub(e),h))}e.add(Gl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Bl.copy(n.boundingSphere),Bl.applyMatrix4(r),br.copy(t.ray).recast(t.near),!(Bl.containsPoint(br.origin)===!1&&(br.intersectSphere(Bl,qp)===null||br.origin.distanceToSquared(qp)>(t.far-t.near)**2))&&(Xp.copy(r).invert(),br.copy(t.ray).applyMatrix4(Xp),!(n.boundingBox!==null&&br.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,br)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,v=d.length;m<v;m++){let g=d[m],p=o[g.materialIndex],y=Math.max(g.start,f.start),M=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let b=y,C=M;b<C;b+=3){let A=a.getX(b),_=a.getX(b+1),w=a.getX(b+2);s=Wl(this,p,t,n,c,h,u,A,_,w),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let m=Math.max(0,f.start),v=Math.min(a.count,f.start+f.count);for(let g=m,p=v;g<p;g+=3){let y=a.getX(g),M=a.getX(g+1),b=a.getX(g+2);s=Wl(this,o,t,n,c,h,u,y,M,b),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,v=d.length;m<v;m++){let g=d[m],p=o[g.materialIndex],y=Math.max(g.start,f.start),M=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let b=y,C=M;b<C;b+=3){let A=b,_=b+1,w=b+2;s=Wl(this,p,t,n,c,h,u,A,_,w),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let m=Math.max(0,f.start),v=Math.min(l.count,f.start+f.count);for(let g=m,p=v;g<p;g+=3){let y=g,M=g+1,b=g+2;s=Wl(this,o,t,n,c,h,u,y,M,b),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function Kx(i,t,e,n,s,r,o,a){let l;if(t.side===oi?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===hr,a),l===null)return null;Hl.copy(a),Hl.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Hl);return c<e.near||c>e.far?null:{distance:c,point:Hl.clone(),object:i}}function Wl(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,kl),i.getVertexPosition(l,zl),i.getVertexPosition(c,Vl);let h=Kx(i,t,e,n,kl,zl,Vl,$p);if(h){let u=new O;Is.getBarycoord($p,kl,zl,Vl,u),s&&(h.uv=Is.getInterpolatedAttribute(s,a,l,c,u,new Xt)),r&&(h.uv1=Is.getInterpolatedAttribute(r,a,l,c,u,new Xt)),o&&(h.normal=Is.getInterpolatedAttribute(o,a,l,c,u,new O),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new O,materialIndex:0};Is.getNormal(kl,zl,Vl,d.normal),h.face=d,h.barycoord=u}return h}var yc=class extends hi{constructor(t=null,e=1,n=1,s,r,o,a,l,c=On,h=On,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Sr=new Fi,jx=new Xt(.5,.5),Xl=new O,nr=class{constructor(t=new Si,e=new Si,n=new Si,s=new Si,r=new Si,o=new Si){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Ni,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],m=r[8],v=r[9],g=r[10],p=r[11],y=r[12],M=r[13],b=r[14],C=r[15];if(s[0].setComponents(c-o,f-h,p-m,C-y).normalize(),s[1].setComponents(c+o,f+h,p+m,C+y).normalize(),s[2].setComponents(c+a,f+u,p+v,C+M).normalize(),s[3].setComponents(c-a,f-u,p-v,C-M).normalize(),n)s[4].setComponents(l,d,g,b).normalize(),s[5].setComponents(c-l,f-d,p-g,C-b).normalize();else if(s[4].setComponents(c-l,f-d,p-g,C-b).normalize(),e===Ni)s[5].setComponents(c+l,f+d,p+g,C+b).normalize();else if(e===Mo)s[5].setComponents(l,d,g,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Sr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Sr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Sr)}intersectsSprite(t){Sr.center.set(0,0,0);let e=jx.distanceTo(t.center);return Sr.radius=.7071067811865476+e,Sr.applyMatrix4(t.matrixWorld),this.intersectsSphere(Sr)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(Xl.x=s.normal.x>0?t.max.x:t.min.x,Xl.y=s.normal.y>0?t.max.y:t.min.y,Xl.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Xl)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Yp=new be,vc=class i{constructor(){this.coordinateSystem=Ni,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Yp.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new nr),n[s].setFromProjectionMatrix(Yp,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new nr),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var ui=class extends us{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Zt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},bc=new O,Sc=new O,Zp=new be,fa=new er,ql=new Fi,hd=new O,Kp=new O,Ui=class extends Bn{constructor(t=new Ee,e=new ui){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)bc.fromBufferAttribute(e,s-1),Sc.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=bc.distanceTo(Sc);t.setAttribute("lineDistance",new Ze(n,1))}else $t("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),ql.copy(n.boundingSphere),ql.applyMatrix4(s),ql.radius+=r,t.ray.intersectsSphere(ql)===!1)return;Zp.copy(s).invert(),fa.copy(t.ray).applyMatrix4(Zp);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),m=Math.min(h.count,o.start+o.count);for(let v=f,g=m-1;v<g;v+=c){let p=h.getX(v),y=h.getX(v+1),M=$l(this,t,fa,l,p,y,v);M&&e.push(M)}if(this.isLineLoop){let v=h.getX(m-1),g=h.getX(f),p=$l(this,t,fa,l,v,g,m-1);p&&e.push(p)}}else{let f=Math.max(0,o.start),m=Math.min(d.count,o.start+o.count);for(let v=f,g=m-1;v<g;v+=c){let p=$l(this,t,fa,l,v,v+1,v);p&&e.push(p)}if(this.isLineLoop){let v=$l(this,t,fa,l,m-1,f,m-1);v&&e.push(v)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function $l(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(bc.fromBufferAttribute(a,s),Sc.fromBufferAttribute(a,r),e.distanceSqToSegment(bc,Sc,hd,Kp)>n)return;hd.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(hd);if(!(c<t.near||c>t.far))return{distance:c,point:Kp.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var jp=new O,Jp=new O,Ti=class extends Ui{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)jp.fromBufferAttribute(e,s),Jp.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+jp.distanceTo(Jp);t.setAttribute("lineDistance",new Ze(n,1))}else $t("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Mc=class extends us{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Zt(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Qp=new be,xd=new er,Yl=new Fi,Zl=new O,Mr=class extends Bn{constructor(t=new Ee,e=new Mc){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Yl.copy(n.boundingSphere),Yl.applyMatrix4(s),Yl.radius+=r,t.ray.intersectsSphere(Yl)===!1)return;Qp.copy(s).invert(),xd.copy(t.ray).applyMatrix4(Qp);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,u=n.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let m=d,v=f;m<v;m++){let g=c.getX(m);Zl.fromBufferAttribute(u,g),tm(Zl,g,l,s,t,e,this)}}else{let d=Math.max(0,o.start),f=Math.min(u.count,o.start+o.count);for(let m=d,v=f;m<v;m++)Zl.fromBufferAttribute(u,m),tm(Zl,m,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function tm(i,t,e,n,s,r,o){let a=xd.distanceSqToPoint(i);if(a<e){let l=new O;xd.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var Ea=class extends hi{constructor(t=[],e=Cr,n,s,r,o,a,l,c,h){super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Us=class extends hi{constructor(t,e,n=Yi,s,r,o,a=On,l=On,c,h=Ns,u=1){if(h!==Ns&&h!==Bs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Eo(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Aa=class extends Us{constructor(t,e=Yi,n=Cr,s,r,o=On,a=On,l,c=Ns){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Ca=class extends hi{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},ir=class i extends Ee{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;m("z","y","x",-1,-1,n,e,t,o,r,0),m("z","y","x",1,-1,n,e,-t,o,r,1),m("x","z","y",1,1,t,n,e,s,o,2),m("x","z","y",1,-1,t,n,-e,s,o,3),m("x","y","z",1,-1,t,e,n,s,r,4),m("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Ze(c,3)),this.setAttribute("normal",new Ze(h,3)),this.setAttribute("uv",new Ze(u,2));function m(v,g,p,y,M,b,C,A,_,w,U){let F=b/_,I=C/w,V=b/2,H=C/2,N=A/2,X=_+1,Y=w+1,W=0,ct=0,j=new O;for(let Q=0;Q<Y;Q++){let st=Q*I-H;for(let dt=0;dt<X;dt++){let ut=dt*F-V;j[v]=ut*y,j[g]=st*M,j[p]=N,c.push(j.x,j.y,j.z),j[v]=0,j[g]=0,j[p]=A>0?1:-1,h.push(j.x,j.y,j.z),u.push(dt/_),u.push(1-Q/w),W+=1}}for(let Q=0;Q<w;Q++)for(let st=0;st<_;st++){let dt=d+st+X*Q,ut=d+st+X*(Q+1),tt=d+(st+1)+X*(Q+1),mt=d+(st+1)+X*Q;l.push(dt,ut,mt),l.push(ut,tt,mt),ct+=6}a.addGroup(f,ct,U),f+=ct,d+=W}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Ro=class i extends Ee{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],m=0,v=[],g=n/2,p=0;y(),o===!1&&(t>0&&M(!0),e>0&&M(!1)),this.setIndex(h),this.setAttribute("position",new Ze(u,3)),this.setAttribute("normal",new Ze(d,3)),this.setAttribute("uv",new Ze(f,2));function y(){let b=new O,C=new O,A=0,_=(e-t)/n;for(let w=0;w<=r;w++){let U=[],F=w/r,I=F*(e-t)+t;for(let V=0;V<=s;V++){let H=V/s,N=H*l+a,X=Math.sin(N),Y=Math.cos(N);C.x=I*X,C.y=-F*n+g,C.z=I*Y,u.push(C.x,C.y,C.z),b.set(X,_,Y).normalize(),d.push(b.x,b.y,b.z),f.push(H,1-F),U.push(m++)}v.push(U)}for(let w=0;w<s;w++)for(let U=0;U<r;U++){let F=v[U][w],I=v[U+1][w],V=v[U+1][w+1],H=v[U][w+1];(t>0||U!==0)&&(h.push(F,I,H),A+=3),(e>0||U!==r-1)&&(h.push(I,V,H),A+=3)}c.addGroup(p,A,0),p+=A}function M(b){let C=m,A=new Xt,_=new O,w=0,U=b===!0?t:e,F=b===!0?1:-1;for(let V=1;V<=s;V++)u.push(0,g*F,0),d.push(0,F,0),f.push(.5,.5),m++;let I=m;for(let V=0;V<=s;V++){let N=V/s*l+a,X=Math.cos(N),Y=Math.sin(N);_.x=U*Y,_.y=g*F,_.z=U*X,u.push(_.x,_.y,_.z),d.push(0,F,0),A.x=X*.5+.5,A.y=Y*.5*F+.5,f.push(A.x,A.y),m++}for(let V=0;V<s;V++){let H=C+V,N=I+V;b===!0?h.push(N,N+1,H):h.push(N+1,N,H),w+=3}c.addGroup(p,w,b===!0?1:2),p+=w}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Ra=class i extends Ro{constructor(t=1,e=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var Kl=new O,jl=new O,ud=new O,Jl=new Is,wr=class extends Ee{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(vo*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),d=new Map,f=[];for(let m=0;m<l;m+=3){o?(c[0]=o.getX(m),c[1]=o.getX(m+1),c[2]=o.getX(m+2)):(c[0]=m,c[1]=m+1,c[2]=m+2);let{a:v,b:g,c:p}=Jl;if(v.fromBufferAttribute(a,c[0]),g.fromBufferAttribute(a,c[1]),p.fromBufferAttribute(a,c[2]),Jl.getNormal(ud),u[0]=`${Math.round(v.x*s)},${Math.round(v.y*s)},${Math.round(v.z*s)}`,u[1]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,u[2]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let y=0;y<3;y++){let M=(y+1)%3,b=u[y],C=u[M],A=Jl[h[y]],_=Jl[h[M]],w=`${b}_${C}`,U=`${C}_${b}`,F=d.get(U);F?(ud.dot(F.normal)<=r&&(f.push(A.x,A.y,A.z),f.push(_.x,_.y,_.z)),d.set(U,null)):d.has(w)||d.set(w,{index0:c[y],index1:c[M],normal:ud.clone()})}}for(let m of d.values())if(m){let{index0:v,index1:g}=m;Kl.fromBufferAttribute(a,v),jl.fromBufferAttribute(a,g),f.push(Kl.x,Kl.y,Kl.z),f.push(jl.x,jl.y,jl.z)}this.setAttribute("position",new Ze(f,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var Pa=class i extends Ee{constructor(t=[new Xt(0,-.5),new Xt(.5,0),new Xt(0,.5)],e=12,n=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:n,phiLength:s},e=Math.floor(e),s=re(s,0,Math.PI*2);let r=[],o=[],a=[],l=[],c=[],h=1/e,u=new O,d=new Xt,f=new O,m=new O,v=new O,g=0,p=0;for(let y=0;y<=t.length-1;y++)switch(y){case 0:g=t[y+1].x-t[y].x,p=t[y+1].y-t[y].y,f.x=p*1,f.y=-g,f.z=p*0,v.copy(f),f.normalize(),l.push(f.x,f.y,f.z);break;case t.length-1:v.normalize(),l.push(v.x,v.y,v.z);break;default:g=t[y+1].x-t[y].x,p=t[y+1].y-t[y].y,f.x=p*1,f.y=-g,f.z=p*0,m.copy(f),f.x+=v.x,f.y+=v.y,f.z+=v.z,f.normalize(),l.push(f.x,f.y,f.z),v.copy(m)}for(let y=0;y<=e;y++){let M=n+y*h*s,b=Math.sin(M),C=Math.cos(M);for(let A=0;A<=t.length-1;A++){u.x=t[A].x*b,u.y=t[A].y,u.z=t[A].x*C,o.push(u.x,u.y,u.z),d.x=y/e,d.y=A/(t.length-1),a.push(d.x,d.y);let _=l[3*A+0]*b,w=l[3*A+1],U=l[3*A+0]*C;c.push(_,w,U)}}for(let y=0;y<e;y++)for(let M=0;M<t.length-1;M++){let b=M+y*t.length,C=b,A=b+t.length,_=b+t.length+1,w=b+1;r.push(C,A,w),r.push(_,w,A)}this.setIndex(r),this.setAttribute("position",new Ze(o,3)),this.setAttribute("uv",new Ze(a,2)),this.setAttribute("normal",new Ze(c,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.points,t.segments,t.phiStart,t.phiLength)}};var La=class i extends Ee{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=t/a,d=e/l,f=[],m=[],v=[],g=[];for(let p=0;p<h;p++){let y=p*d-o;for(let M=0;M<c;M++){let b=M*u-r;m.push(b,-y,0),v.push(0,0,1),g.push(M/a),g.push(1-p/l)}}for(let p=0;p<l;p++)for(let y=0;y<a;y++){let M=y+c*p,b=y+c*(p+1),C=y+1+c*(p+1),A=y+1+c*p;f.push(M,b,A),f.push(b,C,A)}this.setIndex(f),this.setAttribute("position",new Ze(m,3)),this.setAttribute("normal",new Ze(v,3)),this.setAttribute("uv",new Ze(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var Ia=class extends Ee{constructor(t=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:t},t!==null){let e=[],n=new Set,s=new O,r=new O;if(t.index!==null){let o=t.attributes.position,a=t.index,l=t.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,h=l.length;c<h;++c){let u=l[c],d=u.start,f=u.count;for(let m=d,v=d+f;m<v;m+=3)for(let g=0;g<3;g++){let p=a.getX(m+g),y=a.getX(m+(g+1)%3);s.fromBufferAttribute(o,p),r.fromBufferAttribute(o,y),em(s,r,n)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}}else{let o=t.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let h=3*a+c,u=3*a+(c+1)%3;s.fromBufferAttribute(o,h),r.fromBufferAttribute(o,u),em(s,r,n)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}this.setAttribute("position",new Ze(e,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};function em(i,t,e){let n=`${i.x},${i.y},${i.z}-${t.x},${t.y},${t.z}`,s=`${t.x},${t.y},${t.z}-${i.x},${i.y},${i.z}`;return e.has(n)===!0||e.has(s)===!0?!1:(e.add(n),e.add(s),!0)}function Pr(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(nm(s))s.isRenderTargetTexture?($t("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(nm(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function Kn(i){let t={};for(let e=0;e<i.length;e++){let n=Pr(i[e]);for(let s in n)t[s]=n[s]}return t}function nm(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Jx(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function jd(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ye.workingColorSpace}var ja={clone:Pr,merge:Kn},Qx=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,ty=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,kn=class extends us{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Qx,this.fragmentShader=ty,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Pr(t.uniforms),this.uniformsGroups=Jx(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new Zt().setHex(s.value);break;case"v2":this.uniforms[n].value=new Xt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new O().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Ie().fromArray(s.value);break;case"m3":this.uniforms[n].value=new ne().fromArray(s.value);break;case"m4":this.uniforms[n].value=new be().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},wc=class extends kn{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var di=class extends us{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Zt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Zt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Th,this.normalScale=new Xt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Fs,this.combine=kc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Tc=class extends us{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Nm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Ec=class extends us{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};var Da=class extends ui{constructor(t){super(),this.isLineDashedMaterial=!0,this.type="LineDashedMaterial",this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(t)}copy(t){return super.copy(t),this.scale=t.scale,this.dashSize=t.dashSize,this.gapSize=t.gapSize,this}};function mo(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function Ql(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var sr=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Ac=class extends sr{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:md,endingEnd:md}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case gd:r=t,a=2*e-n;break;case _d:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case gd:o=t,l=2*n-e;break;case _d:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,m=(n-e)/(s-e),v=m*m,g=v*m,p=-d*g+2*d*v-d*m,y=(1+d)*g+(-1.5-2*d)*v+(-.5+d)*m+1,M=(-1-f)*g+(1.5+f)*v+.5*m,b=f*g-f*v;for(let C=0;C!==a;++C)r[C]=p*o[h+C]+y*o[c+C]+M*o[l+C]+b*o[u+C];return r}},Cc=class extends sr{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(n-e)/(s-e),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},Rc=class extends sr{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Pc=class extends sr{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let m=(n-e)/(s-e),v=1-m;for(let g=0;g!==a;++g)r[g]=o[c+g]*v+o[l+g]*m;return r}let d=a*2,f=t-1;for(let m=0;m!==a;++m){let v=o[c+m],g=o[l+m],p=f*d+m*2,y=u[p],M=u[p+1],b=t*d+m*2,C=h[b],A=h[b+1],_=ny(n,e,y,C,s);r[m]=$m(_,v,M,A,g)}return r}};function $m(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function ey(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function ny(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=$m(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let l=ey(r,t,e,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Ei=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=mo(e,this.TimeBufferType),this.values=mo(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:mo(t.times,Array),values:mo(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),Ql(t.settings)&&(n.settings={inTangents:mo(t.settings.inTangents,Array),outTangents:mo(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Rc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Cc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Ac(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Pc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ga:e=this.InterpolantFactoryMethodDiscrete;break;case pc:e=this.InterpolantFactoryMethodLinear;break;case ic:e=this.InterpolantFactoryMethodSmooth;break;case pd:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return $t("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ga;case this.InterpolantFactoryMethodLinear:return pc;case this.InterpolantFactoryMethodSmooth:return ic;case this.InterpolantFactoryMethodBezier:return pd}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;Ql(this.settings)&&(im(this.settings.inTangents,t),im(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;Ql(this.settings)&&(sm(this.settings.inTangents,t),sm(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ee("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(ee("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){ee("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){ee("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&xx(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ee("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===ic,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*n,d=u-n,f=u+n;for(let m=0;m!==n;++m){let v=e[u+m];if(v!==e[d+m]||v!==e[f+m]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)e[d+f]=e[u+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,Ql(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function im(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function sm(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}Ei.prototype.ValueTypeName="";Ei.prototype.TimeBufferType=Float32Array;Ei.prototype.ValueBufferType=Float32Array;Ei.prototype.DefaultInterpolation=pc;var rr=class extends Ei{constructor(t,e,n){super(t,e,n)}};rr.prototype.ValueTypeName="bool";rr.prototype.ValueBufferType=Array;rr.prototype.DefaultInterpolation=ga;rr.prototype.InterpolantFactoryMethodLinear=void 0;rr.prototype.InterpolantFactoryMethodSmooth=void 0;var Lc=class extends Ei{constructor(t,e,n,s){super(t,e,n,s)}};Lc.prototype.ValueTypeName="color";var Ic=class extends Ei{constructor(t,e,n,s){super(t,e,n,s)}};Ic.prototype.ValueTypeName="number";var Dc=class extends sr{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)Gn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Na=class extends Ei{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new Dc(this.times,this.values,this.getValueSize(),t)}};Na.prototype.ValueTypeName="quaternion";Na.prototype.InterpolantFactoryMethodSmooth=void 0;var or=class extends Ei{constructor(t,e,n){super(t,e,n)}};or.prototype.ValueTypeName="string";or.prototype.ValueBufferType=Array;or.prototype.DefaultInterpolation=ga;or.prototype.InterpolantFactoryMethodLinear=void 0;or.prototype.InterpolantFactoryMethodSmooth=void 0;var Nc=class extends Ei{constructor(t,e,n,s){super(t,e,n,s)}};Nc.prototype.ValueTypeName="vector";var Fc=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],m=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Ym=new Fc,Uc=class{constructor(t){this.manager=t!==void 0?t:Ym,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Uc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Fa=class extends Bn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Zt(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},Ua=class extends Fa{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Bn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Zt(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},dd=new be,rm=new O,om=new O,Oc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Xt(512,512),this.mapType=fi,this.map=null,this.mapPass=null,this.matrix=new be,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new nr,this._frameExtents=new Xt(1,1),this._viewportCount=1,this._viewports=[new Ie(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;rm.setFromMatrixPosition(t.matrixWorld),e.position.copy(rm),om.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(om),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){dd.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(dd,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===Mo||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(dd)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},tc=new O,ec=new Gn,cs=new O,Oa=class extends Bn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new be,this.projectionMatrix=new be,this.projectionMatrixInverse=new be,this.coordinateSystem=Ni,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(tc,ec,cs),cs.x===1&&cs.y===1&&cs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(tc,ec,cs.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(tc,ec,cs),cs.x===1&&cs.y===1&&cs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(tc,ec,cs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},tr=new O,am=new Xt,lm=new Xt,Mi=class extends Oa{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=To*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(vo*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return To*2*Math.atan(Math.tan(vo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){tr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(tr.x,tr.y).multiplyScalar(-t/tr.z),tr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(tr.x,tr.y).multiplyScalar(-t/tr.z)}getViewSize(t,e){return this.getViewBounds(t,am,lm),e.subVectors(lm,am)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(vo*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Tr=class extends Oa{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},yd=class extends Oc{constructor(){super(new Tr(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ba=class extends Fa{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Bn.DEFAULT_UP),this.updateMatrix(),this.target=new Bn,this.shadow=new yd}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var ka=class extends Ee{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(t){return super.copy(t),this.instanceCount=t.instanceCount,this}toJSON(){let t=super.toJSON();return t.instanceCount=this.instanceCount,t.isInstancedBufferGeometry=!0,t}};var go=-90,_o=1,Po=class extends Bn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Mi(go,_o,t,e);s.layers=this.layers,this.add(s);let r=new Mi(go,_o,t,e);r.layers=this.layers,this.add(r);let o=new Mi(go,_o,t,e);o.layers=this.layers,this.add(o);let a=new Mi(go,_o,t,e);a.layers=this.layers,this.add(a);let l=new Mi(go,_o,t,e);l.layers=this.layers,this.add(l);let c=new Mi(go,_o,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Ni)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Mo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;let v=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=v,t.setRenderTarget(n,5,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,d,f),t.xr.enabled=m,n.texture.needsPMREMUpdate=!0}},Bc=class extends Mi{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Jd="\\[\\]\\.:\\/",iy=new RegExp("["+Jd+"]","g"),Qd="[^"+Jd+"]",sy="[^"+Jd.replace("\\.","")+"]",ry=/((?:WC+[\/:])*)/.source.replace("WC",Qd),oy=/(WCOD+)?/.source.replace("WCOD",sy),ay=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Qd),ly=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Qd),cy=new RegExp("^"+ry+oy+ay+ly+"$"),hy=["material","materials","bones","map"],vd=class{constructor(t,e,n){let s=n||Ye.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},Ye=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(iy,"")}static parseTrackName(t){let e=cy.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);hy.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){$t("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){ee("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ee("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ee("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ee("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ee("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){ee("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){ee("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;ee("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ee("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ee("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ye.Composite=vd;Ye.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ye.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ye.prototype.GetterByBindingType=[Ye.prototype._getValue_direct,Ye.prototype._getValue_array,Ye.prototype._getValue_arrayElement,Ye.prototype._getValue_toArray];Ye.prototype.SetterByBindingTypeAndVersioning=[[Ye.prototype._setValue_direct,Ye.prototype._setValue_direct_setNeedsUpdate,Ye.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_array,Ye.prototype._setValue_array_setNeedsUpdate,Ye.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_arrayElement,Ye.prototype._setValue_arrayElement_setNeedsUpdate,Ye.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_fromArray,Ye.prototype._setValue_fromArray_setNeedsUpdate,Ye.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var bE=new Float32Array(1);var ar=class extends xc{constructor(t,e,n=1){super(t,e),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}clone(t){let e=super.clone(t);return e.meshPerAttribute=this.meshPerAttribute,e}toJSON(t){let e=super.toJSON(t);return e.isInstancedInterleavedBuffer=!0,e.meshPerAttribute=this.meshPerAttribute,e}};var Lo=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=re(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(re(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var bd=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var cm=new O,nc=new O,xo=new O,yo=new O,fd=new O,uy=new O,dy=new O,za=class{constructor(t=new O,e=new O){this.start=t,this.end=e}set(t,e){return this.start.copy(t),this.end.copy(e),this}copy(t){return this.start.copy(t.start),this.end.copy(t.end),this}getCenter(t){return t.addVectors(this.start,this.end).multiplyScalar(.5)}delta(t){return t.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(t,e){return this.delta(e).multiplyScalar(t).add(this.start)}closestPointToPointParameter(t,e){cm.subVectors(t,this.start),nc.subVectors(this.end,this.start);let n=nc.dot(nc);if(n===0)return 0;let r=nc.dot(cm)/n;return e&&(r=re(r,0,1)),r}closestPointToPoint(t,e,n){let s=this.closestPointToPointParameter(t,e);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(t,e=uy,n=dy){let s=10000000000000001e-32,r,o,a=this.start,l=t.start,c=this.end,h=t.end;xo.subVectors(c,a),yo.subVectors(h,l),fd.subVectors(a,l);let u=xo.dot(xo),d=yo.dot(yo),f=yo.dot(fd);if(u<=s&&d<=s)return e.copy(a),n.copy(l),e.distanceToSquared(n);if(u<=s)r=0,o=f/d,o=re(o,0,1);else{let m=xo.dot(fd);if(d<=s)o=0,r=re(-m/u,0,1);else{let v=xo.dot(yo),g=u*d-v*v;g!==0?r=re((v*f-m*d)/g,0,1):r=0,o=(v*r+f)/d,o<0?(o=0,r=re(-m/u,0,1)):o>1&&(o=1,r=re((v-m)/u,0,1))}}return e.copy(a).addScaledVector(xo,r),n.copy(l).addScaledVector(yo,o),e.distanceToSquared(n)}applyMatrix4(t){return this.start.applyMatrix4(t),this.end.applyMatrix4(t),this}equals(t){return t.start.equals(this.start)&&t.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var Va=class extends qi{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function tf(i,t,e,n){let s=fy(n);switch(e){case zd:return i*t;case Gd:return i*t/s.components*s.byteLength;case qc:return i*t/s.components*s.byteLength;case ur:return i*t*2/s.components*s.byteLength;case $c:return i*t*2/s.components*s.byteLength;case Vd:return i*t*3/s.components*s.byteLength;case ji:return i*t*4/s.components*s.byteLength;case Yc:return i*t*4/s.components*s.byteLength;case Wa:case Xa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case qa:case $a:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Kc:case Jc:return Math.max(i,16)*Math.max(t,8)/4;case Zc:case jc:return Math.max(i,8)*Math.max(t,8)/2;case Qc:case th:case nh:case ih:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case eh:case Ya:case sh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case rh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case oh:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case ah:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case lh:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case ch:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case hh:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case uh:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case dh:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case fh:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case ph:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case mh:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case gh:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case _h:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case xh:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case yh:case vh:case bh:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Sh:case Mh:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Za:case wh:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function fy(i){switch(i){case fi:case Ud:return{byteLength:1,components:1};case Fo:case Od:case Ki:return{byteLength:2,components:1};case Wc:case Xc:return{byteLength:2,components:4};case Yi:case Hc:case Zi:return{byteLength:4,components:1};case Bd:case kd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?$t("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function gg(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function my(i){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,m)=>f.start-m.start);let d=0;for(let f=1;f<u.length;f++){let m=u[d],v=u[f];v.start<=m.start+m.count+1?m.count=Math.max(m.count,v.start+v.count-m.start):(++d,u[d]=v)}u.length=d+1;for(let f=0,m=u.length;f<m;f++){let v=u[f];i.bufferSubData(c,v.start*h.BYTES_PER_ELEMENT,h,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var gy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,_y=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,xy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,yy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,vy=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,by=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Sy=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,My=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,wy=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Ty=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Ey=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Ay=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Cy=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Ry=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Py=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Ly=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Iy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Dy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Ny=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Fy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Uy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Oy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,By=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,ky=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,zy=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Vy=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Gy=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Hy=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Wy=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Xy="gl_FragColor = linearToOutputTexel( gl_FragColor );",qy=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,$y=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Yy=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Zy=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Ky=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,jy=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Jy=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Qy=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,tv=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,ev=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,nv=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,iv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,sv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,rv=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,ov=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,av=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,lv=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,cv=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,hv=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,uv=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,dv=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,fv=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,pv=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,mv=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,gv=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,_v=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,xv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,yv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,vv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,bv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Sv=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Mv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,wv=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Tv=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Ev=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Av=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Cv=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Rv=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Pv=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Lv=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Iv=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Dv=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Nv=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Fv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Uv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Ov=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Bv=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,kv=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,zv=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Vv=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Gv=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Hv=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Wv=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Xv=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,qv=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,$v=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Yv=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Zv=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Kv=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,jv=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,Jv=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Qv=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,tb=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,eb=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,nb=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,ib=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,sb=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,rb=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,ob=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,ab=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,lb=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,cb=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,hb=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,ub=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,db=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,fb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,pb=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,mb=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,gb=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,_b=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,xb=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,yb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,vb=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,bb=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,Sb=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Mb=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,wb=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,Tb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Eb=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ab=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Cb=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Rb=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,Pb=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Lb=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Ib=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Db=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Nb=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Fb=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Ub=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Ob=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Bb=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,kb=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,zb=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Vb=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Gb=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Hb=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Wb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Xb=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,qb=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,$b=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Yb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,de={alphahash_fragment:gy,alphahash_pars_fragment:_y,alphamap_fragment:xy,alphamap_pars_fragment:yy,alphatest_fragment:vy,alphatest_pars_fragment:by,aomap_fragment:Sy,aomap_pars_fragment:My,batching_pars_vertex:wy,batching_vertex:Ty,begin_vertex:Ey,beginnormal_vertex:Ay,bsdfs:Cy,iridescence_fragment:Ry,bumpmap_pars_fragment:Py,clipping_planes_fragment:Ly,clipping_planes_pars_fragment:Iy,clipping_planes_pars_vertex:Dy,clipping_planes_vertex:Ny,color_fragment:Fy,color_pars_fragment:Uy,color_pars_vertex:Oy,color_vertex:By,common:ky,defaultnormal_vertex:zy,displacementmap_pars_vertex:Vy,displacementmap_vertex:Gy,emissivemap_fragment:Hy,emissivemap_pars_fragment:Wy,colorspace_fragment:Xy,colorspace_pars_fragment:qy,envmap_fragment:$y,envmap_common_pars_fragment:Yy,envmap_pars_fragment:Zy,envmap_pars_vertex:Ky,envmap_physical_pars_fragment:av,envmap_vertex:jy,fog_vertex:Jy,fog_pars_vertex:Qy,fog_fragment:tv,fog_pars_fragment:ev,gradientmap_pars_fragment:nv,lightmap_pars_fragment:iv,lights_lambert_fragment:sv,lights_lambert_pars_fragment:rv,lights_pars_begin:ov,lights_toon_fragment:lv,lights_toon_pars_fragment:cv,lights_phong_fragment:hv,lights_phong_pars_fragment:uv,lights_physical_fragment:dv,lights_physical_pars_fragment:fv,lights_fragment_begin:pv,lights_fragment_maps:mv,lights_fragment_end:gv,lightprobes_pars_fragment:_v,logdepthbuf_fragment:xv,logdepthbuf_pars_fragment:yv,logdepthbuf_pars_vertex:vv,logdepthbuf_vertex:bv,map_fragment:Sv,map_pars_fragment:Mv,map_particle_fragment:wv,map_particle_pars_fragment:Tv,metalnessmap_fragment:Ev,metalnessmap_pars_fragment:Av,morphinstance_vertex:Cv,morphcolor_vertex:Rv,morphnormal_vertex:Pv,morphtarget_pars_vertex:Lv,morphtarget_vertex:Iv,normal_fragment_begin:Dv,normal_fragment_maps:Nv,normal_pars_fragment:Fv,normal_pars_vertex:Uv,normal_vertex:Ov,normalmap_pars_fragment:Bv,clearcoat_normal_fragment_begin:kv,clearcoat_normal_fragment_maps:zv,clearcoat_pars_fragment:Vv,iridescence_pars_fragment:Gv,opaque_fragment:Hv,packing:Wv,premultiplied_alpha_fragment:Xv,project_vertex:qv,dithering_fragment:$v,dithering_pars_fragment:Yv,roughnessmap_fragment:Zv,roughnessmap_pars_fragment:Kv,shadowmap_pars_fragment:jv,shadowmap_pars_vertex:Jv,shadowmap_vertex:Qv,shadowmask_pars_fragment:tb,skinbase_vertex:eb,skinning_pars_vertex:nb,skinning_vertex:ib,skinnormal_vertex:sb,specularmap_fragment:rb,specularmap_pars_fragment:ob,tonemapping_fragment:ab,tonemapping_pars_fragment:lb,transmission_fragment:cb,transmission_pars_fragment:hb,uv_pars_fragment:ub,uv_pars_vertex:db,uv_vertex:fb,worldpos_vertex:pb,background_vert:mb,background_frag:gb,backgroundCube_vert:_b,backgroundCube_frag:xb,cube_vert:yb,cube_frag:vb,depth_vert:bb,depth_frag:Sb,distance_vert:Mb,distance_frag:wb,equirect_vert:Tb,equirect_frag:Eb,linedashed_vert:Ab,linedashed_frag:Cb,meshbasic_vert:Rb,meshbasic_frag:Pb,meshlambert_vert:Lb,meshlambert_frag:Ib,meshmatcap_vert:Db,meshmatcap_frag:Nb,meshnormal_vert:Fb,meshnormal_frag:Ub,meshphong_vert:Ob,meshphong_frag:Bb,meshphysical_vert:kb,meshphysical_frag:zb,meshtoon_vert:Vb,meshtoon_frag:Gb,points_vert:Hb,points_frag:Wb,shadow_vert:Xb,shadow_frag:qb,sprite_vert:$b,sprite_frag:Yb},Pt={common:{diffuse:{value:new Zt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ne},alphaMap:{value:null},alphaMapTransform:{value:new ne},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ne}},envmap:{envMap:{value:null},envMapRotation:{value:new ne},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ne}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ne}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ne},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ne},normalScale:{value:new Xt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ne},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ne}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ne}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ne}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Zt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Zt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ne},alphaTest:{value:0},uvTransform:{value:new ne}},sprite:{diffuse:{value:new Zt(16777215)},opacity:{value:1},center:{value:new Xt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ne},alphaMap:{value:null},alphaMapTransform:{value:new ne},alphaTest:{value:0}}},ai={basic:{uniforms:Kn([Pt.common,Pt.specularmap,Pt.envmap,Pt.aomap,Pt.lightmap,Pt.fog]),vertexShader:de.meshbasic_vert,fragmentShader:de.meshbasic_frag},lambert:{uniforms:Kn([Pt.common,Pt.specularmap,Pt.envmap,Pt.aomap,Pt.lightmap,Pt.emissivemap,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,Pt.fog,Pt.lights,{emissive:{value:new Zt(0)},envMapIntensity:{value:1}}]),vertexShader:de.meshlambert_vert,fragmentShader:de.meshlambert_frag},phong:{uniforms:Kn([Pt.common,Pt.specularmap,Pt.envmap,Pt.aomap,Pt.lightmap,Pt.emissivemap,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,Pt.fog,Pt.lights,{emissive:{value:new Zt(0)},specular:{value:new Zt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:de.meshphong_vert,fragmentShader:de.meshphong_frag},standard:{uniforms:Kn([Pt.common,Pt.envmap,Pt.aomap,Pt.lightmap,Pt.emissivemap,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,Pt.roughnessmap,Pt.metalnessmap,Pt.fog,Pt.lights,{emissive:{value:new Zt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:de.meshphysical_vert,fragmentShader:de.meshphysical_frag},toon:{uniforms:Kn([Pt.common,Pt.aomap,Pt.lightmap,Pt.emissivemap,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,Pt.gradientmap,Pt.fog,Pt.lights,{emissive:{value:new Zt(0)}}]),vertexShader:de.meshtoon_vert,fragmentShader:de.meshtoon_frag},matcap:{uniforms:Kn([Pt.common,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,Pt.fog,{matcap:{value:null}}]),vertexShader:de.meshmatcap_vert,fragmentShader:de.meshmatcap_frag},points:{uniforms:Kn([Pt.points,Pt.fog]),vertexShader:de.points_vert,fragmentShader:de.points_frag},dashed:{uniforms:Kn([Pt.common,Pt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:de.linedashed_vert,fragmentShader:de.linedashed_frag},depth:{uniforms:Kn([Pt.common,Pt.displacementmap]),vertexShader:de.depth_vert,fragmentShader:de.depth_frag},normal:{uniforms:Kn([Pt.common,Pt.bumpmap,Pt.normalmap,Pt.displacementmap,{opacity:{value:1}}]),vertexShader:de.meshnormal_vert,fragmentShader:de.meshnormal_frag},sprite:{uniforms:Kn([Pt.sprite,Pt.fog]),vertexShader:de.sprite_vert,fragmentShader:de.sprite_frag},background:{uniforms:{uvTransform:{value:new ne},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:de.background_vert,fragmentShader:de.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ne}},vertexShader:de.backgroundCube_vert,fragmentShader:de.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:de.cube_vert,fragmentShader:de.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:de.equirect_vert,fragmentShader:de.equirect_frag},distance:{uniforms:Kn([Pt.common,Pt.displacementmap,{referencePosition:{value:new O},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:de.distance_vert,fragmentShader:de.distance_frag},shadow:{uniforms:Kn([Pt.lights,Pt.fog,{color:{value:new Zt(0)},opacity:{value:1}}]),vertexShader:de.shadow_vert,fragmentShader:de.shadow_frag}};ai.physical={uniforms:Kn([ai.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ne},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ne},clearcoatNormalScale:{value:new Xt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ne},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ne},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ne},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ne},sheen:{value:0},sheenColor:{value:new Zt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ne},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ne},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ne},transmissionSamplerSize:{value:new Xt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ne},attenuationDistance:{value:0},attenuationColor:{value:new Zt(0)},specularColor:{value:new Zt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ne},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ne},anisotropyVector:{value:new Xt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ne}}]),vertexShader:de.meshphysical_vert,fragmentShader:de.meshphysical_frag};var Ah={r:0,b:0,g:0},Zb=new be,_g=new ne;_g.set(-1,0,0,0,1,0,0,0,1);function Kb(i,t,e,n,s,r){let o=new Zt(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(y){let M=y.isScene===!0?y.background:null;if(M&&M.isTexture){let b=y.backgroundBlurriness>0;M=t.get(M,b)}return M}function m(y){let M=!1,b=f(y);b===null?g(o,a):b&&b.isColor&&(g(b,1),M=!0);let C=i.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||M)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function v(y,M){let b=f(M);b&&b.isCubeTexture?(c===void 0&&(c=new Ke(new ir(1,1,1),new kn({name:"BackgroundCubeMaterial",uniforms:Pr(ai.backgroundCube.uniforms),vertexShader:ai.backgroundCube.vertexShader,fragmentShader:ai.backgroundCube.fragmentShader,side:oi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,A,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Zb.makeRotationFromEuler(M.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(_g),c.material.toneMapped=ye.getTransfer(b.colorSpace)!==Le,(h!==b||u!==b.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Ke(new La(2,2),new kn({name:"BackgroundMaterial",uniforms:Pr(ai.background.uniforms),vertexShader:ai.background.vertexShader,fragmentShader:ai.background.fragmentShader,side:hr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=ye.getTransfer(b.colorSpace)!==Le,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||u!==b.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function g(y,M){y.getRGB(Ah,jd(i)),e.buffers.color.setClear(Ah.r,Ah.g,Ah.b,M,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,M=1){o.set(y),a=M,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,g(o,a)},render:m,addToRenderList:v,dispose:p}}function jb(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(I,V,H,N,X){let Y=!1,W=u(I,N,H,V);r!==W&&(r=W,c(r.object)),Y=f(I,N,H,X),Y&&m(I,N,H,X),X!==null&&t.update(X,i.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,b(I,V,H,N),X!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(X).buffer))}function l(){return i.createVertexArray()}function c(I){return i.bindVertexArray(I)}function h(I){return i.deleteVertexArray(I)}function u(I,V,H,N){let X=N.wireframe===!0,Y=n[V.id];Y===void 0&&(Y={},n[V.id]=Y);let W=I.isInstancedMesh===!0?I.id:0,ct=Y[W];ct===void 0&&(ct={},Y[W]=ct);let j=ct[H.id];j===void 0&&(j={},ct[H.id]=j);let Q=j[X];return Q===void 0&&(Q=d(l()),j[X]=Q),Q}function d(I){let V=[],H=[],N=[];for(let X=0;X<e;X++)V[X]=0,H[X]=0,N[X]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:V,enabledAttributes:H,attributeDivisors:N,object:I,attributes:{},index:null}}function f(I,V,H,N){let X=r.attributes,Y=V.attributes,W=0,ct=H.getAttributes();for(let j in ct)if(ct[j].location>=0){let st=X[j],dt=Y[j];if(dt===void 0&&(j==="instanceMatrix"&&I.instanceMatrix&&(dt=I.instanceMatrix),j==="instanceColor"&&I.instanceColor&&(dt=I.instanceColor)),st===void 0||st.attribute!==dt||dt&&st.data!==dt.data)return!0;W++}return r.attributesNum!==W||r.index!==N}function m(I,V,H,N){let X={},Y=V.attributes,W=0,ct=H.getAttributes();for(let j in ct)if(ct[j].location>=0){let st=Y[j];st===void 0&&(j==="instanceMatrix"&&I.instanceMatrix&&(st=I.instanceMatrix),j==="instanceColor"&&I.instanceColor&&(st=I.instanceColor));let dt={};dt.attribute=st,st&&st.data&&(dt.data=st.data),X[j]=dt,W++}r.attributes=X,r.attributesNum=W,r.index=N}function v(){let I=r.newAttributes;for(let V=0,H=I.length;V<H;V++)I[V]=0}function g(I){p(I,0)}function p(I,V){let H=r.newAttributes,N=r.enabledAttributes,X=r.attributeDivisors;H[I]=1,N[I]===0&&(i.enableVertexAttribArray(I),N[I]=1),X[I]!==V&&(i.vertexAttribDivisor(I,V),X[I]=V)}function y(){let I=r.newAttributes,V=r.enabledAttributes;for(let H=0,N=V.length;H<N;H++)V[H]!==I[H]&&(i.disableVertexAttribArray(H),V[H]=0)}function M(I,V,H,N,X,Y,W){W===!0?i.vertexAttribIPointer(I,V,H,X,Y):i.vertexAttribPointer(I,V,H,N,X,Y)}function b(I,V,H,N){v();let X=N.attributes,Y=H.getAttributes(),W=V.defaultAttributeValues;for(let ct in Y){let j=Y[ct];if(j.location>=0){let Q=X[ct];if(Q===void 0&&(ct==="instanceMatrix"&&I.instanceMatrix&&(Q=I.instanceMatrix),ct==="instanceColor"&&I.instanceColor&&(Q=I.instanceColor)),Q!==void 0){let st=Q.normalized,dt=Q.itemSize,ut=t.get(Q);if(ut===void 0)continue;let tt=ut.buffer,mt=ut.type,xt=ut.bytesPerElement,At=mt===i.INT||mt===i.UNSIGNED_INT||Q.gpuType===Hc;if(Q.isInterleavedBufferAttribute){let St=Q.data,Ht=St.isInterleavedBuffer===!0?St.stride:St.itemSize,oe=Q.offset;if(St.isInstancedInterleavedBuffer||St.isInstancedBufferAttribute){for(let Vt=0;Vt<j.locationSize;Vt++)p(j.location+Vt,St.meshPerAttribute);I.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=St.meshPerAttribute*St.count)}else for(let Vt=0;Vt<j.locationSize;Vt++)g(j.location+Vt);i.bindBuffer(i.ARRAY_BUFFER,tt);for(let Vt=0;Vt<j.locationSize;Vt++)M(j.location+Vt,dt/j.locationSize,mt,st,Ht*xt,(oe+dt/j.locationSize*Vt)*xt,At)}else{if(Q.isInstancedBufferAttribute){for(let St=0;St<j.locationSize;St++)p(j.location+St,Q.meshPerAttribute);I.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let St=0;St<j.locationSize;St++)g(j.location+St);i.bindBuffer(i.ARRAY_BUFFER,tt);for(let St=0;St<j.locationSize;St++)M(j.location+St,dt/j.locationSize,mt,st,dt*xt,dt/j.locationSize*St*xt,At)}}else if(W!==void 0){let st=W[ct];if(st!==void 0)switch(st.length){case 2:i.vertexAttrib2fv(j.location,st);break;case 3:i.vertexAttrib3fv(j.location,st);break;case 4:i.vertexAttrib4fv(j.location,st);break;default:i.vertexAttrib1fv(j.location,st)}}}}y()}function C(){U();for(let I in n){let V=n[I];for(let H in V){let N=V[H];for(let X in N){let Y=N[X];for(let W in Y)h(Y[W].object),delete Y[W];delete N[X]}}delete n[I]}}function A(I){if(n[I.id]===void 0)return;let V=n[I.id];for(let H in V){let N=V[H];for(let X in N){let Y=N[X];for(let W in Y)h(Y[W].object),delete Y[W];delete N[X]}}delete n[I.id]}function _(I){for(let V in n){let H=n[V];for(let N in H){let X=H[N];if(X[I.id]===void 0)continue;let Y=X[I.id];for(let W in Y)h(Y[W].object),delete Y[W];delete X[I.id]}}}function w(I){for(let V in n){let H=n[V],N=I.isInstancedMesh===!0?I.id:0,X=H[N];if(X!==void 0){for(let Y in X){let W=X[Y];for(let ct in W)h(W[ct].object),delete W[ct];delete X[Y]}delete H[N],Object.keys(H).length===0&&delete n[V]}}}function U(){F(),o=!0,r!==s&&(r=s,c(r.object))}function F(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:F,dispose:C,releaseStatesOfGeometry:A,releaseStatesOfObject:w,releaseStatesOfProgram:_,initAttributes:v,enableAttribute:g,disableUnusedAttributes:y}}function Jb(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),e.update(c,n,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];e.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Qb(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==ji&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let w=_===Ki&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==fi&&_!==Zi&&!w&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&($t("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&$t("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&$t("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),m=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),y=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),M=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),C=i.getParameter(i.MAX_SAMPLES),A=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:m,maxTextureSize:v,maxCubemapSize:g,maxAttributes:p,maxVertexUniforms:y,maxVaryings:M,maxFragmentUniforms:b,maxSamples:C,samples:A}}function tS(i){let t=this,e=null,n=0,s=!1,r=!1,o=new Si,a=new ne,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,f){let m=u.clippingPlanes,v=u.clipIntersection,g=u.clipShadows,p=i.get(u);if(!s||m===null||m.length===0||r&&!g)r?h(null):c();else{let y=r?0:n,M=y*4,b=p.clippingState||null;l.value=b,b=h(m,d,M,f);for(let C=0;C!==M;++C)b[C]=e[C];p.clippingState=b,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,d,f,m){let v=u!==null?u.length:0,g=null;if(v!==0){if(g=l.value,m!==!0||g===null){let p=f+v*4,y=d.matrixWorldInverse;a.getNormalMatrix(y),(g===null||g.length<p)&&(g=new Float32Array(p));for(let M=0,b=f;M!==v;++M,b+=4)o.copy(u[M]).applyMatrix4(y,a),o.normal.toArray(g,b),g[b+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=v,t.numIntersection=0,g}}var tl=class extends wi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new Ea(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new ir(5,5,5),r=new kn({name:"CubemapFromEquirect",uniforms:Pr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:oi,blending:Er});r.uniforms.tEquirect.value=e;let o=new Ke(s,r),a=e.minFilter;return e.minFilter===Os&&(e.minFilter=ri),new Po(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},Zm=256,eS=3,nS=20,xg=256,yg=16,iS=3,sS=new O,rS=new Zt,Rh=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Po(1,10,null),this._boxMesh=new Ke(new ir(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=sS}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,m=l.autoClearStencil,v=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(t.background=l.getClearColor(rS));let g=new Po(n,s,h);return g.position.copy(a),g.update(l,t),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=m,t.background=v,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Jm(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=jm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Zm,Yd(t))}_fromTexture(t,e){t.mapping===Cr||t.mapping===No?this._setSize(t.image.length===0?Zm:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=Km(t,!1,!1),n=Math.log2(t)-eS;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Km(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Cr||t.mapping===No?(this._cubemapMaterial===null&&(this._cubemapMaterial=Jm()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=jm()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=oS(),this._integrationMaterial=aS());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/yg);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-iS)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(xg*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=lS());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function Km(i,t,e){return new tl(i,{minFilter:Os,generateMipmaps:t,type:Ki,colorSpace:_a,depthBuffer:e})}function el(i,t,e){return new kn({name:i,uniforms:t,vertexShader:de.cube_vert,fragmentShader:e,side:oi,blending:Er,depthTest:!1,depthWrite:!1})}function oS(){return el("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${xg}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function aS(){return el("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:yg}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function lS(){return el("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${nS}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function jm(){return el("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Jm(){return el("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function cS(i){let t=new WeakMap,e=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===zc||f===Vc)if(t.has(d)){let m=t.get(d).texture;return a(m,d.mapping)}else{let m=d.image;if(m&&m.height>0){let v=new tl(m.height);return v.fromEquirectangularTexture(i,d),t.set(d,v),d.addEventListener("dispose",c),a(v.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,m=f===zc||f===Vc,v=f===Cr||f===No;if(m||v){let g=e.get(d),p=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==p)return n===null&&(n=new Rh(i)),g=m?n.fromEquirectangular(d,g):n.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,e.set(d,g),g.texture;if(g!==void 0)return g.texture;{let y=d.image;return m&&y&&y.height>0||v&&y&&l(y)?(n===null&&(n=new Rh(i)),g=m?n.fromEquirectangular(d):n.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,e.set(d,g),d.addEventListener("dispose",h),g.texture):null}}}return d}function a(d,f){return f===zc?d.mapping=Cr:f===Vc&&(d.mapping=No),d}function l(d){let f=0,m=6;for(let v=0;v<m;v++)d[v]!==void 0&&f++;return f===m}function c(d){let f=d.target;f.removeEventListener("dispose",c);let m=t.get(f);m!==void 0&&(t.delete(f),m.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let m=e.get(f);m!==void 0&&(e.delete(f),m.dispose())}function u(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function hS(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&pa("WebGLRenderer: "+n+" extension not supported."),s}}}function uS(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&t.remove(m.index);for(let g in m.attributes)t.remove(m.attributes[g]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let v=r.get(m);v&&(t.remove(v),r.delete(m)),n.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,e.memory.geometries--}function c(m,v){return s[v.id]!==void 0||(v.addEventListener("dispose",a),s[v.id]=new WeakRef(v),o.register(v,v.id,v),e.memory.geometries++),v}function h(m){let v=m.attributes;for(let g in v)t.update(v[g],i.ARRAY_BUFFER)}function u(m){let v=m.index,g=m.attributes.position,p=0;if(g===void 0)return;let y=v!==null?v.array.length:g.array.length/3-1,M=g.count>=65535?Ta:wa,b=new M(Math.ceil(y/3)*6,1),C=b.array;if(v!==null){let _=v.array;p=v.version;for(let w=0,U=0;w<y;w+=3){let F=_[w+0],I=_[w+1],V=_[w+2];C[U++]=F,C[U++]=I,C[U++]=I,C[U++]=V,C[U++]=V,C[U++]=F}}else{p=g.version;for(let _=0,w=0;_<y;_+=3){let U=_+0,F=_+1,I=_+2;C[w++]=U,C[w++]=F,C[w++]=F,C[w++]=I,C[w++]=I,C[w++]=U}}b.version=p;let A=r.get(m);A&&t.remove(A),r.set(m,b)}function d(m){let v=r.get(m);if(v){let g=m.index;g!==null&&v.version<g.version&&u(m)}else u(m);return r.get(m)}function f(){for(let m in s){let v=s[m].deref();v!==void 0&&l(v)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function dS(i,t,e){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),e.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),e.update(d,n,f))}function h(u,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let v=0;for(let g=0;g<f;g++)v+=d[g];e.update(v,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function fS(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:ee("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function pS(i,t,e){let n=new WeakMap,s=new Ie;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let U=function(){_.dispose(),n.delete(a),a.removeEventListener("dispose",U)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],M=0;f===!0&&(M=1),m===!0&&(M=2),v===!0&&(M=3);let b=a.attributes.position.count*M,C=1;b>t.maxTextureSize&&(C=Math.ceil(b/t.maxTextureSize),b=t.maxTextureSize);let A=new Float32Array(b*C*4*u),_=new ba(A,b,C,u);_.type=Zi,_.needsUpdate=!0;let w=M*4;for(let F=0;F<u;F++){let I=g[F],V=p[F],H=y[F],N=b*C*4*F;for(let X=0;X<I.count;X++){let Y=X*w;f===!0&&(s.fromBufferAttribute(I,X),A[N+Y+0]=s.x,A[N+Y+1]=s.y,A[N+Y+2]=s.z,A[N+Y+3]=0),m===!0&&(s.fromBufferAttribute(V,X),A[N+Y+4]=s.x,A[N+Y+5]=s.y,A[N+Y+6]=s.z,A[N+Y+7]=0),v===!0&&(s.fromBufferAttribute(H,X),A[N+Y+8]=s.x,A[N+Y+9]=s.y,A[N+Y+10]=s.z,A[N+Y+11]=H.itemSize===4?s.w:1)}}d={count:u,texture:_,size:new Xt(b,C)},n.set(a,d),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let f=0;for(let v=0;v<c.length;v++)f+=c[v];let m=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",m),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function mS(i,t,e,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=t.get(c,u);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var gS={[Cd]:"LINEAR_TONE_MAPPING",[Rd]:"REINHARD_TONE_MAPPING",[Pd]:"CINEON_TONE_MAPPING",[Ld]:"ACES_FILMIC_TONE_MAPPING",[Dd]:"AGX_TONE_MAPPING",[Nd]:"NEUTRAL_TONE_MAPPING",[Id]:"CUSTOM_TONE_MAPPING"};function _S(i,t,e,n,s,r){let o=new wi(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Ee;h.setAttribute("position",new Ze([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Ze([0,2,0,0,2,0],2));let u=new wc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new Ke(h,u),f=new Tr(-1,1,1,-1,0,1),m=null,v=null,g=!1,p,y=null,M=[],b=!1;this.setSize=function(C,A){o.setSize(C,A),a!==null&&a.setSize(C,A),l!==null&&l.setSize(C,A);for(let _=0;_<M.length;_++){let w=M[_];w.setSize&&w.setSize(C,A)}},this.setEffects=function(C){M=C,b=M.length>0&&M[0].isRenderPass===!0;let A=o.width,_=o.height;M.length>0&&a===null&&(a=new wi(A,_,{type:Ki,depthBuffer:!1,stencilBuffer:!1}),l=new wi(A,_,{type:Ki,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&M.some(U=>U.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new Us(A,_),r===!0&&(c.format=Bs,c.type=Rr)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let U=0;U<M.length;U++){let F=M[U];F.setSize&&F.setSize(A,_),w&&F.needsDepthTexture===!0&&F.setDepthTexture&&F.setDepthTexture(c)}},this.begin=function(C,A){if(g||C.toneMapping===ds&&M.length===0)return!1;if(y=A,A!==null){let _=A.width,w=A.height;(o.width!==_||o.height!==w)&&this.setSize(_,w)}return b===!1&&C.setRenderTarget(o),p=C.toneMapping,C.toneMapping=ds,!0},this.hasRenderPass=function(){return b},this.end=function(C,A){C.toneMapping=p,g=!0;let _=o,w=a;for(let U=0;U<M.length;U++){let F=M[U];F.enabled!==!1&&(F.render(C,w,_,A),F.needsSwap!==!1&&(_=w,w=w===a?l:a))}if(m!==C.outputColorSpace||v!==C.toneMapping){m=C.outputColorSpace,v=C.toneMapping,u.defines={},ye.getTransfer(m)===Le&&(u.defines.SRGB_TRANSFER="");let U=gS[v];U&&(u.defines[U]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=_.texture,C.setRenderTarget(y),C.render(d,f),y=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var vg=new hi,bg=new Us(1,1),Sg=new Aa(1),Mg=new ba,wg=new _c,Tg=new Ea,Qm=[],tg=[],eg=new Float32Array(16),ng=new Float32Array(9),ig=new Float32Array(4);function Oo(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=Qm[s];if(r===void 0&&(r=new Float32Array(s),Qm[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function Tn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function En(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Lh(i,t){let e=tg[t];e===void 0&&(e=new Int32Array(t),tg[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function xS(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function yS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Tn(e,t))return;i.uniform2fv(this.addr,t),En(e,t)}}function vS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Tn(e,t))return;i.uniform3fv(this.addr,t),En(e,t)}}function bS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Tn(e,t))return;i.uniform4fv(this.addr,t),En(e,t)}}function SS(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Tn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),En(e,t)}else{if(Tn(e,n))return;ig.set(n),i.uniformMatrix2fv(this.addr,!1,ig),En(e,n)}}function MS(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Tn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),En(e,t)}else{if(Tn(e,n))return;ng.set(n),i.uniformMatrix3fv(this.addr,!1,ng),En(e,n)}}function wS(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Tn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),En(e,t)}else{if(Tn(e,n))return;eg.set(n),i.uniformMatrix4fv(this.addr,!1,eg),En(e,n)}}function TS(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function ES(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Tn(e,t))return;i.uniform2iv(this.addr,t),En(e,t)}}function AS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Tn(e,t))return;i.uniform3iv(this.addr,t),En(e,t)}}function CS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Tn(e,t))return;i.uniform4iv(this.addr,t),En(e,t)}}function RS(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function PS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Tn(e,t))return;i.uniform2uiv(this.addr,t),En(e,t)}}function LS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Tn(e,t))return;i.uniform3uiv(this.addr,t),En(e,t)}}function IS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Tn(e,t))return;i.uniform4uiv(this.addr,t),En(e,t)}}function Ih(i){return i.version===0&&(i.compareFunction=Xd,i.needsUpdate=!0),i}function DS(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Ih(bg):r=vg,e.setTexture2D(t||r,s)}function NS(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||wg,s)}function FS(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Ih(Sg):r=Tg,e.setTextureCube(t||r,s)}function US(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||Mg,s)}function OS(i){switch(i){case 5126:return xS;case 35664:return yS;case 35665:return vS;case 35666:return bS;case 35674:return SS;case 35675:return MS;case 35676:return wS;case 5124:case 35670:return TS;case 35667:case 35671:return ES;case 35668:case 35672:return AS;case 35669:case 35673:return CS;case 5125:return RS;case 36294:return PS;case 36295:return LS;case 36296:return IS;case 35678:case 36198:case 36298:case 36306:case 35682:return DS;case 35679:case 36299:case 36307:return NS;case 35680:case 36300:case 36308:case 36293:return FS;case 36289:case 36303:case 36311:case 36292:return US}}function BS(i,t){i.uniform1fv(this.addr,t)}function kS(i,t){let e=Oo(t,this.size,2);i.uniform2fv(this.addr,e)}function zS(i,t){let e=Oo(t,this.size,3);i.uniform3fv(this.addr,e)}function VS(i,t){let e=Oo(t,this.size,4);i.uniform4fv(this.addr,e)}function GS(i,t){let e=Oo(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function HS(i,t){let e=Oo(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function WS(i,t){let e=Oo(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function XS(i,t){i.uniform1iv(this.addr,t)}function qS(i,t){i.uniform2iv(this.addr,t)}function $S(i,t){i.uniform3iv(this.addr,t)}function YS(i,t){i.uniform4iv(this.addr,t)}function ZS(i,t){i.uniform1uiv(this.addr,t)}function KS(i,t){i.uniform2uiv(this.addr,t)}function jS(i,t){i.uniform3uiv(this.addr,t)}function JS(i,t){i.uniform4uiv(this.addr,t)}function QS(i,t,e){let n=this.cache,s=t.length,r=Lh(e,s);Tn(n,r)||(i.uniform1iv(this.addr,r),En(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Ih(bg):o=vg;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function tM(i,t,e){let n=this.cache,s=t.length,r=Lh(e,s);Tn(n,r)||(i.uniform1iv(this.addr,r),En(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||wg,r[o])}function eM(i,t,e){let n=this.cache,s=t.length,r=Lh(e,s);Tn(n,r)||(i.uniform1iv(this.addr,r),En(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Ih(Sg):o=Tg;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function nM(i,t,e){let n=this.cache,s=t.length,r=Lh(e,s);Tn(n,r)||(i.uniform1iv(this.addr,r),En(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Mg,r[o])}function iM(i){switch(i){case 5126:return BS;case 35664:return kS;case 35665:return zS;case 35666:return VS;case 35674:return GS;case 35675:return HS;case 35676:return WS;case 5124:case 35670:return XS;case 35667:case 35671:return qS;case 35668:case 35672:return $S;case 35669:case 35673:return YS;case 5125:return ZS;case 36294:return KS;case 36295:return jS;case 36296:return JS;case 35678:case 36198:case 36298:case 36306:case 35682:return QS;case 35679:case 36299:case 36307:return tM;case 35680:case 36300:case 36308:case 36293:return eM;case 36289:case 36303:case 36311:case 36292:return nM}}var sf=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=OS(e.type)}},rf=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=iM(e.type)}},of=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},ef=/(\w+)(\])?(\[|\.)?/g;function sg(i,t){i.seq.push(t),i.map[t.id]=t}function sM(i,t,e){let n=i.name,s=n.length;for(ef.lastIndex=0;;){let r=ef.exec(n),o=ef.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){sg(e,c===void 0?new sf(a,i,t):new rf(a,i,t));break}else{let u=e.map[a];u===void 0&&(u=new of(a),sg(e,u)),e=u}}}var Uo=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);sM(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function rg(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var rM=37297,oM=0;function aM(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var og=new ne;function lM(i){ye._getMatrix(og,ye.workingColorSpace,i);let t=`mat3( ${og.elements.map(e=>e.toFixed(4))} )`;switch(ye.getTransfer(i)){case xa:return[t,"LinearTransferOETF"];case Le:return[t,"sRGBTransferOETF"];default:return $t("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function ag(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+aM(i.getShaderSource(t),a)}else return r}function cM(i,t){let e=lM(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var hM={[Cd]:"Linear",[Rd]:"Reinhard",[Pd]:"Cineon",[Ld]:"ACESFilmic",[Dd]:"AgX",[Nd]:"Neutral",[Id]:"Custom"};function uM(i,t){let e=hM[t];return e===void 0?($t("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Ch=new O;function dM(){ye.getLuminanceCoefficients(Ch);let i=Ch.x.toFixed(4),t=Ch.y.toFixed(4),e=Ch.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function fM(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Qa).join(`
`)}function pM(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function mM(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Qa(i){return i!==""}function lg(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function cg(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var gM=/^[ \t]*#include +<([\w\d./]+)>/gm;function af(i){return i.replace(gM,_M)}function _M(i,t){let e=de[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return af(e)}var xM=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function hg(i){return i.replace(xM,yM)}function yM(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function ug(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var vM={[Ga]:"SHADOWMAP_TYPE_PCF",[Io]:"SHADOWMAP_TYPE_VSM"};function bM(i){return vM[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var SM={[No]:"ENVMAP_MODE_REFRACTION"};function MM(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":SM[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var wM={[kc]:"ENVMAP_BLENDING_MULTIPLY",[Lm]:"ENVMAP_BLENDING_MIX",[Im]:"ENVMAP_BLENDING_ADD"};function TM(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":wM[i.combine]||"ENVMAP_BLENDING_NONE"}function EM(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=bM(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=MM(e),u=TM(e),d=fM(e),f=pM(r),m=s.createProgram(),v,g,p=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(v=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Qa).join(`
`),v.length>0&&(v+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Qa).join(`
`),g.length>0&&(g+=`
`)):(v=[ug(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Qa).join(`
`),g=[ug(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==ds?"#define TONE_MAPPING":"",e.toneMapping!==ds?de.tonemapping_pars_fragment:"",e.toneMapping!==ds?uM("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",de.colorspace_pars_fragment,cM("linearToOutputTexel",e.outputColorSpace),dM(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Qa).join(`
`)),o=af(o),o=lg(o,e),o=cg(o,e),a=af(a),a=lg(a,e),a=cg(a,e),o=hg(o),a=hg(a),e.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,v=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,g=["#define varying in",e.glslVersion===zs?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===zs?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let y=p+v+o,M=p+g+a,b=rg(s,s.VERTEX_SHADER,y),C=rg(s,s.FRAGMENT_SHADER,M);s.attachShader(m,b),s.attachShader(m,C),e.index0AttributeName!==void 0?s.bindAttribLocation(m,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function A(F){if(i.debug.checkShaderErrors){let I=s.getProgramInfoLog(m)||"",V=s.getShaderInfoLog(b)||"",H=s.getShaderInfoLog(C)||"",N=I.trim(),X=V.trim(),Y=H.trim(),W=!0,ct=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(W=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,m,b,C);else{let j=ag(s,b,"vertex"),Q=ag(s,C,"fragment");ee("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+F.name+`
Material Type: `+F.type+`

Program Info Log: `+N+`
`+j+`
`+Q)}else N!==""?$t("WebGLProgram: Program Info Log:",N):(X===""||Y==="")&&(ct=!1);ct&&(F.diagnostics={runnable:W,programLog:N,vertexShader:{log:X,prefix:v},fragmentShader:{log:Y,prefix:g}})}s.deleteShader(b),s.deleteShader(C),_=new Uo(s,m),w=mM(s,m)}let _;this.getUniforms=function(){return _===void 0&&A(this),_};let w;this.getAttributes=function(){return w===void 0&&A(this),w};let U=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(m,rM)),U},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=oM++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=b,this.fragmentShader=C,this}var AM=0,lf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new cf(t),e.set(t,n)),n}},cf=class{constructor(t){this.id=AM++,this.code=t,this.usedTimes=0}};function CM(i){return i===ur||i===Ya||i===Za}function RM(i,t,e,n,s,r){let o=new Sa,a=new lf,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return l.add(_),_===0?"uv":`uv${_}`}function m(_,w,U,F,I,V){let H=F.fog,N=I.geometry,X=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?F.environment:null,Y=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,W=t.get(_.envMap||X,Y),ct=d[_.type],j=n.precision;_.precision!==null&&(j=n.getMaxPrecision(_.precision),j!==_.precision&&$t("WebGLProgram.getParameters:",_.precision,"not supported, using",j,"instead."));let Q=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,st=Q!==void 0?Q.length:0,dt=0;N.morphAttributes.position!==void 0&&(dt=1),N.morphAttributes.normal!==void 0&&(dt=2),N.morphAttributes.color!==void 0&&(dt=3);let ut,tt,mt,xt;if(ct){let Ct=ai[ct];ut=Ct.vertexShader,tt=Ct.fragmentShader}else{ut=_.vertexShader,tt=_.fragmentShader;let Ct=a.getVertexShaderStage(_),le=a.getFragmentShaderStage(_);a.update(_,Ct,le),mt=Ct.id,xt=le.id}let At=i.getRenderTarget(),St=i.state.buffers.depth.getReversed(),Ht=I.isInstancedMesh===!0,oe=I.isBatchedMesh===!0,Vt=!!_.map,fe=!!_.matcap,he=!!W,ie=he&&W.isPMREMTexture===!0,Je=!!_.aoMap,Ge=!!_.lightMap,pn=!!_.bumpMap&&_.wireframe===!1,Oe=!!_.normalMap,Ln=!!_.displacementMap,Se=!!_.emissiveMap,Sn=!!_.metalnessMap,sn=!!_.roughnessMap,mn=_.anisotropy>0,k=_.clearcoat>0,Rt=_.diffuseRoughness>0,Yt=_.dispersion>0,ae=_.retroreflectivity>0,Mt=_.iridescence>0,ke=_.sheen>0,zt=_.transmission>0,qt=mn&&!!_.anisotropyMap,R=k&&!!_.clearcoatMap,S=k&&!!_.clearcoatNormalMap,q=k&&!!_.clearcoatRoughnessMap,ht=Rt&&!!_.diffuseRoughnessMap,ot=Mt&&!!_.iridescenceMap,_t=Mt&&!!_.iridescenceThicknessMap,yt=ke&&!!_.sheenColorMap,et=ke&&!!_.sheenRoughnessMap,it=!!_.specularMap,pt=!!_.specularColorMap,B=!!_.specularIntensityMap,rt=zt&&!!_.transmissionMap,nt=zt&&!!_.thicknessMap,wt=!!_.gradientMap,gt=!!_.alphaMap,bt=_.alphaTest>0,Gt=!!_.alphaHash,jt=!!_.extensions,lt=ds;_.toneMapped&&(At===null||At.isXRRenderTarget===!0)&&(lt=i.toneMapping);let Ot=ie?W.isCompressedCubeTexture?W.image[0].mipmaps:W.mipmaps:null,Jt={shaderID:ct,shaderType:_.type,shaderName:_.name,vertexShader:ut,fragmentShader:tt,defines:_.defines,customVertexShaderID:mt,customFragmentShaderID:xt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:j,batching:oe,batchingColor:oe&&I._colorsTexture!==null,instancing:Ht,instancingColor:Ht&&I.instanceColor!==null,instancingMorph:Ht&&I.morphTexture!==null,outputColorSpace:At===null?i.outputColorSpace:At.isXRRenderTarget===!0?At.texture.colorSpace:ye.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Vt,matcap:fe,envMap:he,envMapMode:he&&W.mapping,envMapPMREM:ie,envMapMaxLod:ie?Ot.length-1:null,envMapSize:ie?Ot[0].width:null,aoMap:Je,lightMap:Ge,bumpMap:pn,normalMap:Oe,displacementMap:Ln,emissiveMap:Se,normalMapObjectSpace:Oe&&_.normalMapType===Fm,normalMapTangentSpace:Oe&&_.normalMapType===Th,packedNormalMap:Oe&&_.normalMapType===Th&&CM(_.normalMap.format),metalnessMap:Sn,roughnessMap:sn,anisotropy:mn,anisotropyMap:qt,clearcoat:k,clearcoatMap:R,clearcoatNormalMap:S,clearcoatRoughnessMap:q,diffuseRoughness:Rt,diffuseRoughnessMap:ht,dispersion:Yt,retroreflection:ae,iridescence:Mt,iridescenceMap:ot,iridescenceThicknessMap:_t,sheen:ke,sheenColorMap:yt,sheenRoughnessMap:et,specularMap:it,specularColorMap:pt,specularIntensityMap:B,transmission:zt,transmissionMap:rt,thicknessMap:nt,gradientMap:wt,opaque:_.transparent===!1&&_.blending===Do&&_.alphaToCoverage===!1,alphaMap:gt,alphaTest:bt,alphaHash:Gt,combine:_.combine,mapUv:Vt&&f(_.map.channel),aoMapUv:Je&&f(_.aoMap.channel),lightMapUv:Ge&&f(_.lightMap.channel),bumpMapUv:pn&&f(_.bumpMap.channel),normalMapUv:Oe&&f(_.normalMap.channel),displacementMapUv:Ln&&f(_.displacementMap.channel),emissiveMapUv:Se&&f(_.emissiveMap.channel),metalnessMapUv:Sn&&f(_.metalnessMap.channel),roughnessMapUv:sn&&f(_.roughnessMap.channel),anisotropyMapUv:qt&&f(_.anisotropyMap.channel),clearcoatMapUv:R&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:S&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ht&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:ot&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:_t&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:yt&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:et&&f(_.sheenRoughnessMap.channel),specularMapUv:it&&f(_.specularMap.channel),specularColorMapUv:pt&&f(_.specularColorMap.channel),specularIntensityMapUv:B&&f(_.specularIntensityMap.channel),transmissionMapUv:rt&&f(_.transmissionMap.channel),thicknessMapUv:nt&&f(_.thicknessMap.channel),alphaMapUv:gt&&f(_.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Oe||mn),vertexNormals:!!N.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!N.attributes.uv&&(Vt||gt),fog:!!H,useFog:_.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||N.attributes.normal===void 0&&Oe===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:St,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:st,morphTextureStride:dt,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:V.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&U.length>0,shadowMapType:i.shadowMap.type,toneMapping:lt,decodeVideoTexture:Vt&&_.map.isVideoTexture===!0&&ye.getTransfer(_.map.colorSpace)===Le,decodeVideoTextureEmissive:Se&&_.emissiveMap.isVideoTexture===!0&&ye.getTransfer(_.emissiveMap.colorSpace)===Le,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===Ai,flipSided:_.side===oi,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:jt&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(jt&&_.extensions.multiDraw===!0||oe)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return Jt.vertexUv1s=l.has(1),Jt.vertexUv2s=l.has(2),Jt.vertexUv3s=l.has(3),l.clear(),Jt}function v(_){let w=[];if(_.shaderID?w.push(_.shaderID):(w.push(_.customVertexShaderID),w.push(_.customFragmentShaderID)),_.defines!==void 0)for(let U in _.defines)w.push(U),w.push(_.defines[U]);return _.isRawShaderMaterial===!1&&(g(w,_),p(w,_),w.push(i.outputColorSpace)),w.push(_.customProgramCacheKey),w.join()}function g(_,w){_.push(w.precision),_.push(w.outputColorSpace),_.push(w.envMapMode),_.push(w.envMapPMREM),_.push(w.envMapMaxLod),_.push(w.envMapSize),_.push(w.mapUv),_.push(w.alphaMapUv),_.push(w.lightMapUv),_.push(w.aoMapUv),_.push(w.bumpMapUv),_.push(w.normalMapUv),_.push(w.displacementMapUv),_.push(w.emissiveMapUv),_.push(w.metalnessMapUv),_.push(w.roughnessMapUv),_.push(w.anisotropyMapUv),_.push(w.clearcoatMapUv),_.push(w.clearcoatNormalMapUv),_.push(w.clearcoatRoughnessMapUv),_.push(w.diffuseRoughnessMapUv),_.push(w.iridescenceMapUv),_.push(w.iridescenceThicknessMapUv),_.push(w.sheenColorMapUv),_.push(w.sheenRoughnessMapUv),_.push(w.specularMapUv),_.push(w.specularColorMapUv),_.push(w.specularIntensityMapUv),_.push(w.transmissionMapUv),_.push(w.thicknessMapUv),_.push(w.combine),_.push(w.fogExp2),_.push(w.sizeAttenuation),_.push(w.morphTargetsCount),_.push(w.numSunLights),_.push(w.numDirLights),_.push(w.numPointLights),_.push(w.numSpotLights),_.push(w.numSpotLightMaps),_.push(w.numHemiLights),_.push(w.numRectAreaLights),_.push(w.numSunLightShadows),_.push(w.numDirLightShadows),_.push(w.numPointLightShadows),_.push(w.numSpotLightShadows),_.push(w.numSpotLightShadowsWithMaps),_.push(w.numLightProbes),_.push(w.numLightProbeGrids),_.push(w.shadowMapType),_.push(w.toneMapping),_.push(w.numClippingPlanes),_.push(w.numClipIntersection),_.push(w.depthPacking)}function p(_,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function y(_){let w=d[_.type],U;if(w){let F=ai[w];U=ja.clone(F.uniforms)}else U=_.uniforms;return U}function M(_,w){let U=h.get(w);return U!==void 0?++U.usedTimes:(U=new EM(i,w,_,s),c.push(U),h.set(w,U)),U}function b(_){if(--_.usedTimes===0){let w=c.indexOf(_);c[w]=c[c.length-1],c.pop(),h.delete(_.cacheKey),_.destroy()}}function C(_){a.remove(_)}function A(){a.dispose()}return{getParameters:m,getProgramCacheKey:v,getUniforms:y,acquireProgram:M,releaseProgram:b,releaseShaderCache:C,programs:c,dispose:A}}function PM(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function LM(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function dg(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function fg(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,m,v,g,p){let y=i[t];return y===void 0?(y={id:d.id,object:d,geometry:f,material:m,materialVariant:o(d),groupOrder:v,renderOrder:d.renderOrder,z:g,group:p},i[t]=y):(y.id=d.id,y.object=d,y.geometry=f,y.material=m,y.materialVariant=o(d),y.groupOrder=v,y.renderOrder=d.renderOrder,y.z=g,y.group=p),t++,y}function l(d,f,m,v,g,p,y){y.reversedDepth===!0&&(g=-g);let M=a(d,f,m,v,g,p);m.transmission>0?n.push(M):m.transparent===!0?s.push(M):e.push(M)}function c(d,f,m,v,g,p){let y=a(d,f,m,v,g,p);m.transmission>0?n.unshift(y):m.transparent===!0?s.unshift(y):e.unshift(y)}function h(d,f){e.length>1&&e.sort(d||LM),n.length>1&&n.sort(f||dg),s.length>1&&s.sort(f||dg)}function u(){for(let d=t,f=i.length;d<f;d++){let m=i[d];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function IM(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new fg,i.set(n,[o])):s>=r.length?(o=new fg,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function DM(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new O,color:new Zt};break;case"SpotLight":e={position:new O,direction:new O,color:new Zt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new O,color:new Zt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new O,skyColor:new Zt,groundColor:new Zt};break;case"RectAreaLight":e={color:new Zt,position:new O,halfWidth:new O,halfHeight:new O};break}return i[t.id]=e,e}}}function NM(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var FM=0;function UM(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function OM(i){let t=new DM,e=NM(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new O);let s=new O,r=new be,o=new be;function a(c){let h=0,u=0,d=0;for(let V=0;V<9;V++)n.probe[V].set(0,0,0);let f=0,m=0,v=0,g=0,p=0,y=0,M=0,b=0,C=0,A=0,_=0,w=0,U=0,F=0;c.sort(UM);for(let V=0,H=c.length;V<H;V++){let N=c[V],X=N.color,Y=N.intensity,W=N.distance,ct=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===ur?ct=N.shadow.map.texture:ct=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)h+=X.r*Y,u+=X.g*Y,d+=X.b*Y;else if(N.isLightProbe){for(let j=0;j<9;j++)n.probe[j].addScaledVector(N.sh.coefficients[j],Y);F++}else if(N.isSunLight){let j=t.get(N);if(j.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,st=e.get(N);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[m]=st,n.sunShadowMap[m]=ct;let dt=Q.getViewportCount();for(let ut=0;ut<dt;ut++)n.sunShadowMatrix[v+ut]=Q.getMatrix(ut),n.sunShadowCascade[v+ut]=Q._cascadeData[ut];v+=dt,m++}n.sun[f]=j,f++}else if(N.isDirectionalLight){let j=t.get(N);if(j.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,st=e.get(N);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize=Q.mapSize,n.directionalShadow[g]=st,n.directionalShadowMap[g]=ct,n.directionalShadowMatrix[g]=N.shadow.matrix,C++}n.directional[g]=j,g++}else if(N.isSpotLight){let j=t.get(N);j.position.setFromMatrixPosition(N.matrixWorld),j.color.copy(X).multiplyScalar(Y),j.distance=W,j.coneCos=Math.cos(N.angle),j.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),j.decay=N.decay,n.spot[y]=j;let Q=N.shadow;if(N.map&&(n.spotLightMap[w]=N.map,w++,Q.updateMatrices(N),N.castShadow&&U++),n.spotLightMatrix[y]=Q.matrix,N.castShadow){let st=e.get(N);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize=Q.mapSize,n.spotShadow[y]=st,n.spotShadowMap[y]=ct,_++}y++}else if(N.isRectAreaLight){let j=t.get(N);j.color.copy(X).multiplyScalar(Y),j.halfWidth.set(N.width*.5,0,0),j.halfHeight.set(0,N.height*.5,0),n.rectArea[M]=j,M++}else if(N.isPointLight){let j=t.get(N);if(j.color.copy(N.color).multiplyScalar(N.intensity),j.distance=N.distance,j.decay=N.decay,N.castShadow){let Q=N.shadow,st=e.get(N);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize=Q.mapSize,st.shadowCameraNear=Q.camera.near,st.shadowCameraFar=Q.camera.far,n.pointShadow[p]=st,n.pointShadowMap[p]=ct,n.pointShadowMatrix[p]=N.shadow.matrix,A++}n.point[p]=j,p++}else if(N.isHemisphereLight){let j=t.get(N);j.skyColor.copy(N.color).multiplyScalar(Y),j.groundColor.copy(N.groundColor).multiplyScalar(Y),n.hemi[b]=j,b++}}M>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Pt.LTC_FLOAT_1,n.rectAreaLTC2=Pt.LTC_FLOAT_2):(n.rectAreaLTC1=Pt.LTC_HALF_1,n.rectAreaLTC2=Pt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let I=n.hash;(I.sunLength!==f||I.directionalLength!==g||I.pointLength!==p||I.spotLength!==y||I.rectAreaLength!==M||I.hemiLength!==b||I.numSunShadows!==m||I.numDirectionalShadows!==C||I.numPointShadows!==A||I.numSpotShadows!==_||I.numSpotMaps!==w||I.numLightProbes!==F)&&(n.sun.length=f,n.directional.length=g,n.spot.length=y,n.rectArea.length=M,n.point.length=p,n.hemi.length=b,n.sunShadow.length=m,n.sunShadowMap.length=m,n.sunShadowMatrix.length=v,n.sunShadowCascade.length=v,n.directionalShadow.length=C,n.directionalShadowMap.length=C,n.directionalShadowMatrix.length=C,n.pointShadow.length=A,n.pointShadowMap.length=A,n.pointShadowMatrix.length=A,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+w-U,n.spotLightMap.length=w,n.numSpotLightShadowsWithMaps=U,n.numLightProbes=F,I.sunLength=f,I.directionalLength=g,I.pointLength=p,I.spotLength=y,I.rectAreaLength=M,I.hemiLength=b,I.numSunShadows=m,I.numDirectionalShadows=C,I.numPointShadows=A,I.numSpotShadows=_,I.numSpotMaps=w,I.numLightProbes=F,n.version=FM++)}function l(c,h){let u=0,d=0,f=0,m=0,v=0,g=0,p=h.matrixWorldInverse;for(let y=0,M=c.length;y<M;y++){let b=c[y];if(b.isSunLight){let C=n.sun[u];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(p),u++}else if(b.isDirectionalLight){let C=n.directional[d];C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),d++}else if(b.isSpotLight){let C=n.spot[m];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(p),C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),m++}else if(b.isRectAreaLight){let C=n.rectArea[v];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(p),o.identity(),r.copy(b.matrixWorld),r.premultiply(p),o.extractRotation(r),C.halfWidth.set(b.width*.5,0,0),C.halfHeight.set(0,b.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),v++}else if(b.isPointLight){let C=n.point[f];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(p),f++}else if(b.isHemisphereLight){let C=n.hemi[g];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(p),g++}}}return{setup:a,setupView:l,state:n}}function pg(i){let t=new OM(i),e=[],n=[],s=[];function r(u){h.camera=u,e.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){n.push(u)}function l(){t.setup(e),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function BM(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new pg(i),t.set(s,[a])):r>=o.length?(a=new pg(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var kM=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,zM=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,VM=[new O(1,0,0),new O(-1,0,0),new O(0,1,0),new O(0,-1,0),new O(0,0,1),new O(0,0,-1)],GM=[new O(0,-1,0),new O(0,-1,0),new O(0,0,1),new O(0,0,-1),new O(0,-1,0),new O(0,-1,0)],mg=new be,Ja=new O,nf=new O;function HM(i,t,e){let n=new nr,s=new Xt,r=new Xt,o=new Ie,a=new Tc,l=new Ec,c={},h=e.maxTextureSize,u={[hr]:oi,[oi]:hr,[Ai]:Ai},d=new kn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Xt},radius:{value:4}},vertexShader:kM,fragmentShader:zM}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let m=new Ee;m.setAttribute("position",new we(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new Ke(m,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ga;let p=this.type;this.render=function(A,_,w){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||A.length===0)return;this.type===dm&&($t("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ga);let U=i.getRenderTarget(),F=i.getActiveCubeFace(),I=i.getActiveMipmapLevel(),V=i.state;V.setBlending(Er),V.buffers.depth.getReversed()===!0?V.buffers.color.setClear(0,0,0,0):V.buffers.color.setClear(1,1,1,1),V.buffers.depth.setTest(!0),V.setScissorTest(!1);let H=p!==this.type;H&&_.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(X=>X.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,X=A.length;N<X;N++){let Y=A[N],W=Y.shadow;if(W===void 0){$t("WebGLShadowMap:",Y,"has no shadow.");continue}if(W.autoUpdate===!1&&W.needsUpdate===!1)continue;s.copy(W.mapSize);let ct=W.getFrameExtents();s.multiply(ct),r.copy(W.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ct.x),s.x=r.x*ct.x,W.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ct.y),s.y=r.y*ct.y,W.mapSize.y=r.y));let j=i.state.buffers.depth.getReversed();if(W.camera._reversedDepth=j,W.map===null||H===!0){if(W.map!==null&&(W.map.depthTexture!==null&&(W.map.depthTexture.dispose(),W.map.depthTexture=null),W.map.dispose()),this.type===Io){if(Y.isPointLight){$t("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}W.map=new wi(s.x,s.y,{format:ur,type:Ki,minFilter:ri,magFilter:ri,generateMipmaps:!1}),W.map.texture.name=Y.name+".shadowMap",W.map.depthTexture=new Us(s.x,s.y,Zi),W.map.depthTexture.name=Y.name+".shadowMapDepth",W.map.depthTexture.format=Ns,W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=On,W.map.depthTexture.magFilter=On}else Y.isPointLight?(W.map=new tl(s.x),W.map.depthTexture=new Aa(s.x,Yi)):(W.map=new wi(s.x,s.y),W.map.depthTexture=new Us(s.x,s.y,Yi)),W.map.depthTexture.name=Y.name+".shadowMap",W.map.depthTexture.format=Ns,this.type===Ga?(W.map.depthTexture.compareFunction=j?Wd:Hd,W.map.depthTexture.minFilter=ri,W.map.depthTexture.magFilter=ri):(W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=On,W.map.depthTexture.magFilter=On);W.camera.updateProjectionMatrix()}W.map.isWebGLCubeRenderTarget!==!0&&(W.map.width!==s.x||W.map.height!==s.y)&&W.map.setSize(s.x,s.y);let Q=W.map.isWebGLCubeRenderTarget?6:W.getViewportCount();Y.isPointLight!==!0&&W.updateMatrices(Y,w);let st=(W.camera.layers.mask&4294967294)!==0?W.camera.layers:w.layers;for(let dt=0;dt<Q;dt++){let ut=W.getCamera(dt);if(Y.isPointLight){let tt=W.camera,mt=W.matrix,xt=Y.distance||tt.far;xt!==tt.far&&(tt.far=xt,tt.updateProjectionMatrix()),Ja.setFromMatrixPosition(Y.matrixWorld),tt.position.copy(Ja),nf.copy(tt.position),nf.add(VM[dt]),tt.up.copy(GM[dt]),tt.lookAt(nf),tt.updateMatrixWorld(),mt.makeTranslation(-Ja.x,-Ja.y,-Ja.z),mg.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),W._frustum.setFromProjectionMatrix(mg,tt.coordinateSystem,tt.reversedDepth)}if(W.map.isWebGLCubeRenderTarget)i.setRenderTarget(W.map,dt),i.clear();else{dt===0&&(i.setRenderTarget(W.map),i.clear());let tt=W.getViewport(dt);o.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),V.viewport(o)}n=W.getFrustum(dt),b(_,w,ut,Y,st,this.type)}W.isPointLightShadow!==!0&&this.type===Io&&y(W,w),W.needsUpdate=!1}p=this.type,g.needsUpdate=!1,i.setRenderTarget(U,F,I)};function y(A,_){let w=t.update(v);d.defines.VSM_SAMPLES!==A.blurSamples&&(d.defines.VSM_SAMPLES=A.blurSamples,f.defines.VSM_SAMPLES=A.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),A.mapPass===null?A.mapPass=new wi(s.x,s.y,{format:ur,type:Ki}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),d.uniforms.shadow_pass.value=A.map.depthTexture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,i.setRenderTarget(A.mapPass),i.clear(),i.renderBufferDirect(_,null,w,d,v,null),f.uniforms.shadow_pass.value=A.mapPass.texture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,i.setRenderTarget(A.map),i.clear(),i.renderBufferDirect(_,null,w,f,v,null)}function M(A,_,w,U){let F=null,I=w.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(I!==void 0)F=I;else if(F=w.isPointLight===!0?l:a,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let V=F.uuid,H=_.uuid,N=c[V];N===void 0&&(N={},c[V]=N);let X=N[H];X===void 0&&(X=F.clone(),N[H]=X,_.addEventListener("dispose",C)),F=X}if(F.visible=_.visible,F.wireframe=_.wireframe,U===Io?F.side=_.shadowSide!==null?_.shadowSide:_.side:F.side=_.shadowSide!==null?_.shadowSide:u[_.side],F.alphaMap=_.alphaMap,F.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,F.map=_.map,F.clipShadows=_.clipShadows,F.clippingPlanes=_.clippingPlanes,F.clipIntersection=_.clipIntersection,F.displacementMap=_.displacementMap,F.displacementScale=_.displacementScale,F.displacementBias=_.displacementBias,F.wireframeLinewidth=_.wireframeLinewidth,F.linewidth=_.linewidth,w.isPointLight===!0&&F.isMeshDistanceMaterial===!0){let V=i.properties.get(F);V.light=w}return F}function b(A,_,w,U,F,I){if(A.visible===!1)return;if(A.layers.test(F)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&I===Io)&&(!A.frustumCulled||A.intersectsFrustum(n))){A.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,A.matrixWorld);let N=t.update(A),X=A.material;if(Array.isArray(X)){let Y=N.groups;for(let W=0,ct=Y.length;W<ct;W++){let j=Y[W],Q=X[j.materialIndex];if(Q&&Q.visible){let st=M(A,Q,U,I);A.onBeforeShadow(i,A,_,w,N,st,j),i.renderBufferDirect(w,null,N,st,A,j),A.onAfterShadow(i,A,_,w,N,st,j)}}}else if(X.visible){let Y=M(A,X,U,I);A.onBeforeShadow(i,A,_,w,N,Y,null),i.renderBufferDirect(w,null,N,Y,A,null),A.onAfterShadow(i,A,_,w,N,Y,null)}}let H=A.children;for(let N=0,X=H.length;N<X;N++)b(H[N],_,w,U,F,I)}function C(A){A.target.removeEventListener("dispose",C);for(let w in c){let U=c[w],F=A.target.uuid;F in U&&(U[F].dispose(),delete U[F])}}}function WM(i,t){function e(){let B=!1,rt=new Ie,nt=null,wt=new Ie(0,0,0,0);return{setMask:function(gt){nt!==gt&&!B&&(i.colorMask(gt,gt,gt,gt),nt=gt)},setLocked:function(gt){B=gt},setClear:function(gt,bt,Gt,jt,lt){lt===!0&&(gt*=jt,bt*=jt,Gt*=jt),rt.set(gt,bt,Gt,jt),wt.equals(rt)===!1&&(i.clearColor(gt,bt,Gt,jt),wt.copy(rt))},reset:function(){B=!1,nt=null,wt.set(-1,0,0,0)}}}function n(){let B=!1,rt=!1,nt=null,wt=null,gt=null;return{setReversed:function(bt){if(rt!==bt){let Gt=t.get("EXT_clip_control");bt?Gt.clipControlEXT(Gt.LOWER_LEFT_EXT,Gt.ZERO_TO_ONE_EXT):Gt.clipControlEXT(Gt.LOWER_LEFT_EXT,Gt.NEGATIVE_ONE_TO_ONE_EXT),rt=bt;let jt=gt;gt=null,this.setClear(jt)}},getReversed:function(){return rt},setTest:function(bt){bt?St(i.DEPTH_TEST):Ht(i.DEPTH_TEST)},setMask:function(bt){nt!==bt&&!B&&(i.depthMask(bt),nt=bt)},setFunc:function(bt){if(rt&&(bt=Xm[bt]),wt!==bt){switch(bt){case rc:i.depthFunc(i.NEVER);break;case oc:i.depthFunc(i.ALWAYS);break;case ac:i.depthFunc(i.LESS);break;case So:i.depthFunc(i.LEQUAL);break;case lc:i.depthFunc(i.EQUAL);break;case cc:i.depthFunc(i.GEQUAL);break;case hc:i.depthFunc(i.GREATER);break;case uc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}wt=bt}},setLocked:function(bt){B=bt},setClear:function(bt){gt!==bt&&(gt=bt,rt&&(bt=1-bt),i.clearDepth(bt))},reset:function(){B=!1,nt=null,wt=null,gt=null,rt=!1}}}function s(){let B=!1,rt=null,nt=null,wt=null,gt=null,bt=null,Gt=null,jt=null,lt=null;return{setTest:function(Ot){B||(Ot?St(i.STENCIL_TEST):Ht(i.STENCIL_TEST))},setMask:function(Ot){rt!==Ot&&!B&&(i.stencilMask(Ot),rt=Ot)},setFunc:function(Ot,Jt,Ct){(nt!==Ot||wt!==Jt||gt!==Ct)&&(i.stencilFunc(Ot,Jt,Ct),nt=Ot,wt=Jt,gt=Ct)},setOp:function(Ot,Jt,Ct){(bt!==Ot||Gt!==Jt||jt!==Ct)&&(i.stencilOp(Ot,Jt,Ct),bt=Ot,Gt=Jt,jt=Ct)},setLocked:function(Ot){B=Ot},setClear:function(Ot){lt!==Ot&&(i.clearStencil(Ot),lt=Ot)},reset:function(){B=!1,rt=null,nt=null,wt=null,gt=null,bt=null,Gt=null,jt=null,lt=null}}}let r=new e,o=new n,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,m=[],v=null,g=!1,p=null,y=null,M=null,b=null,C=null,A=null,_=null,w=new Zt(0,0,0),U=0,F=!1,I=null,V=null,H=null,N=null,X=null,Y=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),W=!1,ct=0,j=i.getParameter(i.VERSION);j.indexOf("WebGL")!==-1?(ct=parseFloat(/^WebGL (\d)/.exec(j)[1]),W=ct>=1):j.indexOf("OpenGL ES")!==-1&&(ct=parseFloat(/^OpenGL ES (\d)/.exec(j)[1]),W=ct>=2);let Q=null,st={},dt=i.getParameter(i.SCISSOR_BOX),ut=i.getParameter(i.VIEWPORT),tt=new Ie().fromArray(dt),mt=new Ie().fromArray(ut);function xt(B,rt,nt,wt){let gt=new Uint8Array(4),bt=i.createTexture();i.bindTexture(B,bt),i.texParameteri(B,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(B,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Gt=0;Gt<nt;Gt++)B===i.TEXTURE_3D||B===i.TEXTURE_2D_ARRAY?i.texImage3D(rt,0,i.RGBA,1,1,wt,0,i.RGBA,i.UNSIGNED_BYTE,gt):i.texImage2D(rt+Gt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,gt);return bt}let At={};At[i.TEXTURE_2D]=xt(i.TEXTURE_2D,i.TEXTURE_2D,1),At[i.TEXTURE_CUBE_MAP]=xt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),At[i.TEXTURE_2D_ARRAY]=xt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),At[i.TEXTURE_3D]=xt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),St(i.DEPTH_TEST),o.setFunc(So),pn(!1),Oe(Sd),St(i.CULL_FACE),Je(Er);function St(B){h[B]!==!0&&(i.enable(B),h[B]=!0)}function Ht(B){h[B]!==!1&&(i.disable(B),h[B]=!1)}function oe(B,rt){return d[B]!==rt?(i.bindFramebuffer(B,rt),d[B]=rt,B===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=rt),B===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=rt),!0):!1}function Vt(B,rt){let nt=m,wt=!1;if(B){nt=f.get(rt),nt===void 0&&(nt=[],f.set(rt,nt));let gt=B.textures;if(nt.length!==gt.length||nt[0]!==i.COLOR_ATTACHMENT0){for(let bt=0,Gt=gt.length;bt<Gt;bt++)nt[bt]=i.COLOR_ATTACHMENT0+bt;nt.length=gt.length,wt=!0}}else nt[0]!==i.BACK&&(nt[0]=i.BACK,wt=!0);wt&&i.drawBuffers(nt)}function fe(B){return v!==B?(i.useProgram(B),v=B,!0):!1}let he={[Ar]:i.FUNC_ADD,[pm]:i.FUNC_SUBTRACT,[mm]:i.FUNC_REVERSE_SUBTRACT};he[gm]=i.MIN,he[_m]=i.MAX;let ie={[xm]:i.ZERO,[ym]:i.ONE,[vm]:i.SRC_COLOR,[Ed]:i.SRC_ALPHA,[Em]:i.SRC_ALPHA_SATURATE,[wm]:i.DST_COLOR,[Sm]:i.DST_ALPHA,[bm]:i.ONE_MINUS_SRC_COLOR,[Ad]:i.ONE_MINUS_SRC_ALPHA,[Tm]:i.ONE_MINUS_DST_COLOR,[Mm]:i.ONE_MINUS_DST_ALPHA,[Am]:i.CONSTANT_COLOR,[Cm]:i.ONE_MINUS_CONSTANT_COLOR,[Rm]:i.CONSTANT_ALPHA,[Pm]:i.ONE_MINUS_CONSTANT_ALPHA};function Je(B,rt,nt,wt,gt,bt,Gt,jt,lt,Ot){if(B===Er){g===!0&&(Ht(i.BLEND),g=!1);return}if(g===!1&&(St(i.BLEND),g=!0),B!==fm){if(B!==p||Ot!==F){if((y!==Ar||C!==Ar)&&(i.blendEquation(i.FUNC_ADD),y=Ar,C=Ar),Ot)switch(B){case Do:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Md:i.blendFunc(i.ONE,i.ONE);break;case wd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Td:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:ee("WebGLState: Invalid blending: ",B);break}else switch(B){case Do:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Md:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case wd:ee("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Td:ee("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ee("WebGLState: Invalid blending: ",B);break}M=null,b=null,A=null,_=null,w.set(0,0,0),U=0,p=B,F=Ot}return}gt=gt||rt,bt=bt||nt,Gt=Gt||wt,(rt!==y||gt!==C)&&(i.blendEquationSeparate(he[rt],he[gt]),y=rt,C=gt),(nt!==M||wt!==b||bt!==A||Gt!==_)&&(i.blendFuncSeparate(ie[nt],ie[wt],ie[bt],ie[Gt]),M=nt,b=wt,A=bt,_=Gt),(jt.equals(w)===!1||lt!==U)&&(i.blendColor(jt.r,jt.g,jt.b,lt),w.copy(jt),U=lt),p=B,F=!1}function Ge(B,rt){B.side===Ai?Ht(i.CULL_FACE):St(i.CULL_FACE);let nt=B.side===oi;rt&&(nt=!nt),pn(nt),B.blending===Do&&B.transparent===!1?Je(Er):Je(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);let wt=B.stencilWrite;a.setTest(wt),wt&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),Se(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?St(i.SAMPLE_ALPHA_TO_COVERAGE):Ht(i.SAMPLE_ALPHA_TO_COVERAGE)}function pn(B){I!==B&&(B?i.frontFace(i.CW):i.frontFace(i.CCW),I=B)}function Oe(B){B!==hm?(St(i.CULL_FACE),B!==V&&(B===Sd?i.cullFace(i.BACK):B===um?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ht(i.CULL_FACE),V=B}function Ln(B){B!==H&&(W&&i.lineWidth(B),H=B)}function Se(B,rt,nt){B?(St(i.POLYGON_OFFSET_FILL),(N!==rt||X!==nt)&&(N=rt,X=nt,o.getReversed()&&(rt=-rt,nt=-nt),i.polygonOffset(rt,nt))):Ht(i.POLYGON_OFFSET_FILL)}function Sn(B){B?St(i.SCISSOR_TEST):Ht(i.SCISSOR_TEST)}function sn(B){B===void 0&&(B=i.TEXTURE0+Y-1),Q!==B&&(i.activeTexture(B),Q=B)}function mn(B,rt,nt){nt===void 0&&(Q===null?nt=i.TEXTURE0+Y-1:nt=Q);let wt=st[nt];wt===void 0&&(wt={type:void 0,texture:void 0},st[nt]=wt),(wt.type!==B||wt.texture!==rt)&&(Q!==nt&&(i.activeTexture(nt),Q=nt),i.bindTexture(B,rt||At[B]),wt.type=B,wt.texture=rt)}function k(){let B=st[Q];B!==void 0&&B.type!==void 0&&(i.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function Rt(){try{i.compressedTexImage2D(...arguments)}catch(B){ee("WebGLState:",B)}}function Yt(){try{i.compressedTexImage3D(...arguments)}catch(B){ee("WebGLState:",B)}}function ae(){try{i.texSubImage2D(...arguments)}catch(B){ee("WebGLState:",B)}}function Mt(){try{i.texSubImage3D(...arguments)}catch(B){ee("WebGLState:",B)}}function ke(){try{i.compressedTexSubImage2D(...arguments)}catch(B){ee("WebGLState:",B)}}function zt(){try{i.compressedTexSubImage3D(...arguments)}catch(B){ee("WebGLState:",B)}}function qt(){try{i.texStorage2D(...arguments)}catch(B){ee("WebGLState:",B)}}function R(){try{i.texStorage3D(...arguments)}catch(B){ee("WebGLState:",B)}}function S(){try{i.texImage2D(...arguments)}catch(B){ee("WebGLState:",B)}}function q(){try{i.texImage3D(...arguments)}catch(B){ee("WebGLState:",B)}}function ht(B){return u[B]!==void 0?u[B]:i.getParameter(B)}function ot(B,rt){u[B]!==rt&&(i.pixelStorei(B,rt),u[B]=rt)}function _t(B){tt.equals(B)===!1&&(i.scissor(B.x,B.y,B.z,B.w),tt.copy(B))}function yt(B){mt.equals(B)===!1&&(i.viewport(B.x,B.y,B.z,B.w),mt.copy(B))}function et(B,rt){let nt=c.get(rt);nt===void 0&&(nt=new WeakMap,c.set(rt,nt));let wt=nt.get(B);wt===void 0&&(wt=i.getUniformBlockIndex(rt,B.name),i.uniformBlockBinding(rt,wt,wt),nt.set(B,wt))}function it(B,rt,nt){let gt=c.get(rt).get(B);l[gt]!==nt&&(i.bindBufferBase(i.UNIFORM_BUFFER,gt,nt),l[gt]=nt)}function pt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,st={},d={},l={},f=new WeakMap,m=[],v=null,g=!1,p=null,y=null,M=null,b=null,C=null,A=null,_=null,w=new Zt(0,0,0),U=0,F=!1,I=null,V=null,H=null,N=null,X=null,tt.set(0,0,i.canvas.width,i.canvas.height),mt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:St,disable:Ht,bindFramebuffer:oe,drawBuffers:Vt,useProgram:fe,setBlending:Je,setMaterial:Ge,setFlipSided:pn,setCullFace:Oe,setLineWidth:Ln,setPolygonOffset:Se,setScissorTest:Sn,activeTexture:sn,bindTexture:mn,unbindTexture:k,compressedTexImage2D:Rt,compressedTexImage3D:Yt,texImage2D:S,texImage3D:q,pixelStorei:ot,getParameter:ht,updateUBOMapping:et,uniformBlockBinding:it,texStorage2D:qt,texStorage3D:R,texSubImage2D:ae,texSubImage3D:Mt,compressedTexSubImage2D:ke,compressedTexSubImage3D:zt,scissor:_t,viewport:yt,reset:pt}}function XM(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Xt,h=new WeakMap,u=new Set,d,f=new WeakMap,m=new Set,v=new FinalizationRegistry(R=>m.delete(R)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(R,S){return g?new OffscreenCanvas(R,S):ya("canvas")}function y(R,S,q){let ht=1,ot=qt(R);if((ot.width>q||ot.height>q)&&(ht=q/Math.max(ot.width,ot.height)),ht<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let _t=Math.floor(ht*ot.width),yt=Math.floor(ht*ot.height);d===void 0&&(d=p(_t,yt));let et=S?p(_t,yt):d;return et.width=_t,et.height=yt,et.getContext("2d").drawImage(R,0,0,_t,yt),$t("WebGLRenderer: Texture has been resized from ("+ot.width+"x"+ot.height+") to ("+_t+"x"+yt+")."),et}else return"data"in R&&$t("WebGLRenderer: Image in DataTexture is too big ("+ot.width+"x"+ot.height+")."),R;return R}function M(R){return R.generateMipmaps}function b(R){i.generateMipmap(R)}function C(R){return R.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?i.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function A(R,S,q,ht,ot,_t=!1){if(R!==null){if(i[R]!==void 0)return i[R];$t("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let yt;ht&&(yt=t.get("EXT_texture_norm16"),yt||$t("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let et=S;if(S===i.RED&&(q===i.FLOAT&&(et=i.R32F),q===i.HALF_FLOAT&&(et=i.R16F),q===i.UNSIGNED_BYTE&&(et=i.R8),q===i.UNSIGNED_SHORT&&yt&&(et=yt.R16_EXT),q===i.SHORT&&yt&&(et=yt.R16_SNORM_EXT)),S===i.RED_INTEGER&&(q===i.UNSIGNED_BYTE&&(et=i.R8UI),q===i.UNSIGNED_SHORT&&(et=i.R16UI),q===i.UNSIGNED_INT&&(et=i.R32UI),q===i.BYTE&&(et=i.R8I),q===i.SHORT&&(et=i.R16I),q===i.INT&&(et=i.R32I)),S===i.RG&&(q===i.FLOAT&&(et=i.RG32F),q===i.HALF_FLOAT&&(et=i.RG16F),q===i.UNSIGNED_BYTE&&(et=i.RG8),q===i.UNSIGNED_SHORT&&yt&&(et=yt.RG16_EXT),q===i.SHORT&&yt&&(et=yt.RG16_SNORM_EXT)),S===i.RG_INTEGER&&(q===i.UNSIGNED_BYTE&&(et=i.RG8UI),q===i.UNSIGNED_SHORT&&(et=i.RG16UI),q===i.UNSIGNED_INT&&(et=i.RG32UI),q===i.BYTE&&(et=i.RG8I),q===i.SHORT&&(et=i.RG16I),q===i.INT&&(et=i.RG32I)),S===i.RGB_INTEGER&&(q===i.UNSIGNED_BYTE&&(et=i.RGB8UI),q===i.UNSIGNED_SHORT&&(et=i.RGB16UI),q===i.UNSIGNED_INT&&(et=i.RGB32UI),q===i.BYTE&&(et=i.RGB8I),q===i.SHORT&&(et=i.RGB16I),q===i.INT&&(et=i.RGB32I)),S===i.RGBA_INTEGER&&(q===i.UNSIGNED_BYTE&&(et=i.RGBA8UI),q===i.UNSIGNED_SHORT&&(et=i.RGBA16UI),q===i.UNSIGNED_INT&&(et=i.RGBA32UI),q===i.BYTE&&(et=i.RGBA8I),q===i.SHORT&&(et=i.RGBA16I),q===i.INT&&(et=i.RGBA32I)),S===i.RGB&&(q===i.UNSIGNED_SHORT&&yt&&(et=yt.RGB16_EXT),q===i.SHORT&&yt&&(et=yt.RGB16_SNORM_EXT),q===i.UNSIGNED_INT_5_9_9_9_REV&&(et=i.RGB9_E5),q===i.UNSIGNED_INT_10F_11F_11F_REV&&(et=i.R11F_G11F_B10F)),S===i.RGBA){let it=_t?xa:ye.getTransfer(ot);q===i.FLOAT&&(et=i.RGBA32F),q===i.HALF_FLOAT&&(et=i.RGBA16F),q===i.UNSIGNED_BYTE&&(et=it===Le?i.SRGB8_ALPHA8:i.RGBA8),q===i.UNSIGNED_SHORT&&yt&&(et=yt.RGBA16_EXT),q===i.SHORT&&yt&&(et=yt.RGBA16_SNORM_EXT),q===i.UNSIGNED_SHORT_4_4_4_4&&(et=i.RGBA4),q===i.UNSIGNED_SHORT_5_5_5_1&&(et=i.RGB5_A1)}return(et===i.R16F||et===i.R32F||et===i.RG16F||et===i.RG32F||et===i.RGBA16F||et===i.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function _(R,S){let q;return R?S===null||S===Yi||S===Rr?q=i.DEPTH24_STENCIL8:S===Zi?q=i.DEPTH32F_STENCIL8:S===Fo&&(q=i.DEPTH24_STENCIL8,$t("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Yi||S===Rr?q=i.DEPTH_COMPONENT24:S===Zi?q=i.DEPTH_COMPONENT32F:S===Fo&&(q=i.DEPTH_COMPONENT16),q}function w(R,S){return M(R)===!0||R.isFramebufferTexture&&R.minFilter!==On&&R.minFilter!==ri?Math.log2(Math.max(S.width,S.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?S.mipmaps.length:1}function U(R){let S=new WeakRef(R);n.get(R).__ref=S,m.add(S),v.register(R,S,S)}function F(R){let S=n.get(R).__ref;S!==void 0&&(m.delete(S),v.unregister(S))}function I(R){H(R.target)}function V(R){N(R.target)}function H(R){R.removeEventListener("dispose",I),F(R),Y(R),R.isVideoTexture&&h.delete(R),R.isHTMLTexture&&u.delete(R)}function N(R){R.removeEventListener("dispose",V),F(R),ct(R)}function X(){for(let R of m){let S=R.deref();S!==void 0&&(S.isRenderTarget===!0?N(S):H(S))}m.clear(),u.clear()}function Y(R){let S=n.get(R);if(S.__webglInit===void 0)return;let q=R.source,ht=f.get(q);if(ht){let ot=ht[S.__cacheKey];ot.usedTimes--,ot.usedTimes===0&&W(R),Object.keys(ht).length===0&&f.delete(q)}n.remove(R)}function W(R){let S=n.get(R);i.deleteTexture(S.__webglTexture);let q=R.source,ht=f.get(q);delete ht[S.__cacheKey],o.memory.textures--}function ct(R){let S=n.get(R);S.__depthDisposeCallback&&S.__depthDisposeCallback();let q=R.depthTexture;if(q&&q.renderTarget===R&&H(q),R.isWebGLCubeRenderTarget)for(let ot=0;ot<6;ot++){if(Array.isArray(S.__webglFramebuffer[ot]))for(let _t=0;_t<S.__webglFramebuffer[ot].length;_t++)i.deleteFramebuffer(S.__webglFramebuffer[ot][_t]);else i.deleteFramebuffer(S.__webglFramebuffer[ot]);S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer[ot])}else{if(Array.isArray(S.__webglFramebuffer))for(let ot=0;ot<S.__webglFramebuffer.length;ot++)i.deleteFramebuffer(S.__webglFramebuffer[ot]);else i.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&i.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let ot=0;ot<S.__webglColorRenderbuffer.length;ot++)S.__webglColorRenderbuffer[ot]&&i.deleteRenderbuffer(S.__webglColorRenderbuffer[ot]);S.__webglDepthRenderbuffer&&i.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let ht=R.textures;for(let ot=0,_t=ht.length;ot<_t;ot++){let yt=n.get(ht[ot]);yt.__webglTexture&&(i.deleteTexture(yt.__webglTexture),o.memory.textures--),n.remove(ht[ot])}n.remove(R)}let j=0;function Q(){j=0}function st(){return j}function dt(R){j=R}function ut(){let R=j;return R>=s.maxTextures&&$t("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),j+=1,R}function tt(R){let S=[];return S.push(R.wrapS),S.push(R.wrapT),S.push(R.wrapR||0),S.push(R.magFilter),S.push(R.minFilter),S.push(R.anisotropy),S.push(R.internalFormat),S.push(R.format),S.push(R.type),S.push(R.generateMipmaps),S.push(R.mipmapsAutoUpdate),S.push(R.premultiplyAlpha),S.push(R.flipY),S.push(R.unpackAlignment),S.push(R.colorSpace),S.join()}function mt(R,S){let q=n.get(R);if(R.isVideoTexture&&ke(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&q.__version!==R.version){let ht=R.image;if(ht===null)$t("WebGLRenderer: Texture marked for update but no image data found.");else if(ht.complete===!1)$t("WebGLRenderer: Texture marked for update but image is incomplete");else{Ge(q,R,S);return}}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,q.__webglTexture,i.TEXTURE0+S)}function xt(R,S){let q=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Ge(q,R,S);return}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,q.__webglTexture,i.TEXTURE0+S)}function At(R,S){let q=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Ge(q,R,S);return}e.bindTexture(i.TEXTURE_3D,q.__webglTexture,i.TEXTURE0+S)}function St(R,S){let q=n.get(R);if(R.version>0&&q.__version!==R.version){pn(q,R,S);return}e.bindTexture(i.TEXTURE_CUBE_MAP,q.__webglTexture,i.TEXTURE0+S)}let Ht={[dc]:i.REPEAT,[hs]:i.CLAMP_TO_EDGE,[fc]:i.MIRRORED_REPEAT},oe={[On]:i.NEAREST,[Dm]:i.NEAREST_MIPMAP_NEAREST,[Ha]:i.NEAREST_MIPMAP_LINEAR,[ri]:i.LINEAR,[Gc]:i.LINEAR_MIPMAP_NEAREST,[Os]:i.LINEAR_MIPMAP_LINEAR},Vt={[Om]:i.NEVER,[Xd]:i.ALWAYS,[Bm]:i.LESS,[Hd]:i.LEQUAL,[km]:i.EQUAL,[Wd]:i.GEQUAL,[zm]:i.GREATER,[Vm]:i.NOTEQUAL};function fe(R,S){if(S.type===Zi&&t.has("OES_texture_float_linear")===!1&&(S.magFilter===ri||S.magFilter===Gc||S.magFilter===Ha||S.magFilter===Os||S.minFilter===ri||S.minFilter===Gc||S.minFilter===Ha||S.minFilter===Os)&&$t("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(R,i.TEXTURE_WRAP_S,Ht[S.wrapS]),i.texParameteri(R,i.TEXTURE_WRAP_T,Ht[S.wrapT]),(R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY)&&i.texParameteri(R,i.TEXTURE_WRAP_R,Ht[S.wrapR]),i.texParameteri(R,i.TEXTURE_MAG_FILTER,oe[S.magFilter]),i.texParameteri(R,i.TEXTURE_MIN_FILTER,oe[S.minFilter]),S.compareFunction&&(i.texParameteri(R,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(R,i.TEXTURE_COMPARE_FUNC,Vt[S.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===On||S.minFilter!==Ha&&S.minFilter!==Os||S.type===Zi&&t.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||n.get(S).__currentAnisotropy){let q=t.get("EXT_texture_filter_anisotropic");i.texParameterf(R,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),n.get(S).__currentAnisotropy=S.anisotropy}}}function he(R,S){let q=!1;R.__webglInit===void 0&&(R.__webglInit=!0,S.addEventListener("dispose",I),U(S));let ht=S.source,ot=f.get(ht);ot===void 0&&(ot={},f.set(ht,ot));let _t=tt(S);if(_t!==R.__cacheKey){ot[_t]===void 0&&(ot[_t]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,q=!0),ot[_t].usedTimes++;let yt=ot[R.__cacheKey];yt!==void 0&&(ot[R.__cacheKey].usedTimes--,yt.usedTimes===0&&W(S)),R.__cacheKey=_t,R.__webglTexture=ot[_t].texture}return q}function ie(R,S,q){return Math.floor(Math.floor(R/q)/S)}function Je(R,S,q,ht){let _t=R.updateRanges;if(_t.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,S.width,S.height,q,ht,S.data);else{_t.sort((B,rt)=>B.start-rt.start);let yt=0;for(let B=1;B<_t.length;B++){let rt=_t[yt],nt=_t[B],wt=rt.start+rt.count,gt=ie(nt.start,S.width,4),bt=ie(rt.start,S.width,4);nt.start<=wt+1&&gt===bt&&ie(nt.start+nt.count-1,S.width,4)===gt?rt.count=Math.max(rt.count,nt.start+nt.count-rt.start):(++yt,_t[yt]=nt)}_t.length=yt+1;let et=e.getParameter(i.UNPACK_ROW_LENGTH),it=e.getParameter(i.UNPACK_SKIP_PIXELS),pt=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,S.width);for(let B=0,rt=_t.length;B<rt;B++){let nt=_t[B],wt=Math.floor(nt.start/4),gt=Math.ceil(nt.count/4),bt=wt%S.width,Gt=Math.floor(wt/S.width),jt=gt,lt=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,bt),e.pixelStorei(i.UNPACK_SKIP_ROWS,Gt),e.texSubImage2D(i.TEXTURE_2D,0,bt,Gt,jt,lt,q,ht,S.data)}R.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,et),e.pixelStorei(i.UNPACK_SKIP_PIXELS,it),e.pixelStorei(i.UNPACK_SKIP_ROWS,pt)}}function Ge(R,S,q){let ht=i.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(ht=i.TEXTURE_2D_ARRAY),S.isData3DTexture&&(ht=i.TEXTURE_3D);let ot=he(R,S),_t=S.source;e.bindTexture(ht,R.__webglTexture,i.TEXTURE0+q);let yt=n.get(_t);if(_t.version!==yt.__version||ot===!0){if(e.activeTexture(i.TEXTURE0+q),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let lt=ye.getPrimaries(ye.workingColorSpace),Ot=S.colorSpace===ks?null:ye.getPrimaries(S.colorSpace),Jt=S.colorSpace===ks||lt===Ot?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Jt)}e.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment);let it=y(S.image,!1,s.maxTextureSize);it=zt(S,it);let pt=r.convert(S.format,S.colorSpace),B=r.convert(S.type),rt=A(S.internalFormat,pt,B,S.normalized,S.colorSpace,S.isVideoTexture);fe(ht,S);let nt,wt=S.mipmaps,gt=S.isVideoTexture!==!0,bt=yt.__version===void 0||ot===!0,Gt=_t.dataReady,jt=w(S,it);if(S.isDepthTexture)rt=_(S.format===Bs,S.type),bt&&(gt?e.texStorage2D(i.TEXTURE_2D,1,rt,it.width,it.height):e.texImage2D(i.TEXTURE_2D,0,rt,it.width,it.height,0,pt,B,null));else if(S.isDataTexture)if(wt.length>0){gt&&bt&&e.texStorage2D(i.TEXTURE_2D,jt,rt,wt[0].width,wt[0].height);for(let lt=0,Ot=wt.length;lt<Ot;lt++)nt=wt[lt],gt?Gt&&e.texSubImage2D(i.TEXTURE_2D,lt,0,0,nt.width,nt.height,pt,B,nt.data):e.texImage2D(i.TEXTURE_2D,lt,rt,nt.width,nt.height,0,pt,B,nt.data);S.generateMipmaps=!1}else gt?(bt&&e.texStorage2D(i.TEXTURE_2D,jt,rt,it.width,it.height),Gt&&Je(S,it,pt,B)):e.texImage2D(i.TEXTURE_2D,0,rt,it.width,it.height,0,pt,B,it.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){gt&&bt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,jt,rt,wt[0].width,wt[0].height,it.depth);for(let lt=0,Ot=wt.length;lt<Ot;lt++)if(nt=wt[lt],S.format!==ji)if(pt!==null)if(gt){if(Gt)if(S.layerUpdates.size>0){let Jt=tf(nt.width,nt.height,S.format,S.type);for(let Ct of S.layerUpdates){let le=nt.data.subarray(Ct*Jt/nt.data.BYTES_PER_ELEMENT,(Ct+1)*Jt/nt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,lt,0,0,Ct,nt.width,nt.height,1,pt,le)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,lt,0,0,0,nt.width,nt.height,it.depth,pt,nt.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,lt,rt,nt.width,nt.height,it.depth,0,nt.data,0,0);else $t("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else gt?Gt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,lt,0,0,0,nt.width,nt.height,it.depth,pt,B,nt.data):e.texImage3D(i.TEXTURE_2D_ARRAY,lt,rt,nt.width,nt.height,it.depth,0,pt,B,nt.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{gt&&bt&&e.texStorage2D(i.TEXTURE_2D,jt,rt,wt[0].width,wt[0].height);for(let lt=0,Ot=wt.length;lt<Ot;lt++)nt=wt[lt],S.format!==ji?pt!==null?gt?Gt&&e.compressedTexSubImage2D(i.TEXTURE_2D,lt,0,0,nt.width,nt.height,pt,nt.data):e.compressedTexImage2D(i.TEXTURE_2D,lt,rt,nt.width,nt.height,0,nt.data):$t("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):gt?Gt&&e.texSubImage2D(i.TEXTURE_2D,lt,0,0,nt.width,nt.height,pt,B,nt.data):e.texImage2D(i.TEXTURE_2D,lt,rt,nt.width,nt.height,0,pt,B,nt.data)}else if(S.isDataArrayTexture)if(gt){if(bt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,jt,rt,it.width,it.height,it.depth),Gt)if(S.layerUpdates.size>0){let lt=tf(it.width,it.height,S.format,S.type);for(let Ot of S.layerUpdates){let Jt=it.data.subarray(Ot*lt/it.data.BYTES_PER_ELEMENT,(Ot+1)*lt/it.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Ot,it.width,it.height,1,pt,B,Jt)}S.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,it.width,it.height,it.depth,pt,B,it.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,rt,it.width,it.height,it.depth,0,pt,B,it.data);else if(S.isData3DTexture)gt?(bt&&e.texStorage3D(i.TEXTURE_3D,jt,rt,it.width,it.height,it.depth),Gt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,it.width,it.height,it.depth,pt,B,it.data)):e.texImage3D(i.TEXTURE_3D,0,rt,it.width,it.height,it.depth,0,pt,B,it.data);else if(S.isFramebufferTexture){if(bt)if(gt)e.texStorage2D(i.TEXTURE_2D,jt,rt,it.width,it.height);else{let lt=it.width,Ot=it.height;for(let Jt=0;Jt<jt;Jt++)e.texImage2D(i.TEXTURE_2D,Jt,rt,lt,Ot,0,pt,B,null),lt>>=1,Ot>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in i){let lt=i.canvas;if(lt.hasAttribute("layoutsubtree")||lt.setAttribute("layoutsubtree","true"),it.parentNode!==lt){lt.appendChild(it),u.add(S),lt.onpaint=Ot=>{let Jt=Ot.changedElements;for(let Ct of u)Jt.includes(Ct.image)&&(Ct.needsUpdate=!0)},lt.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,it);else{let Jt=i.RGBA,Ct=i.RGBA,le=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Jt,Ct,le,it)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(wt.length>0){if(gt&&bt){let lt=qt(wt[0]);e.texStorage2D(i.TEXTURE_2D,jt,rt,lt.width,lt.height)}for(let lt=0,Ot=wt.length;lt<Ot;lt++)nt=wt[lt],gt?Gt&&e.texSubImage2D(i.TEXTURE_2D,lt,0,0,pt,B,nt):e.texImage2D(i.TEXTURE_2D,lt,rt,pt,B,nt);S.generateMipmaps=!1}else if(gt){if(bt){let lt=qt(it);e.texStorage2D(i.TEXTURE_2D,jt,rt,lt.width,lt.height)}Gt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,pt,B,it)}else e.texImage2D(i.TEXTURE_2D,0,rt,pt,B,it);M(S)&&S.mipmapsAutoUpdate===!0&&b(ht),yt.__version=_t.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function pn(R,S,q){if(S.image.length!==6)return;let ht=he(R,S),ot=S.source;e.bindTexture(i.TEXTURE_CUBE_MAP,R.__webglTexture,i.TEXTURE0+q);let _t=n.get(ot);if(ot.version!==_t.__version||ht===!0){e.activeTexture(i.TEXTURE0+q);let yt=ye.getPrimaries(ye.workingColorSpace),et=S.colorSpace===ks?null:ye.getPrimaries(S.colorSpace),it=S.colorSpace===ks||yt===et?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,it);let pt=S.isCompressedTexture||S.image[0].isCompressedTexture,B=S.image[0]&&S.image[0].isDataTexture,rt=[];for(let Ct=0;Ct<6;Ct++)!pt&&!B?rt[Ct]=y(S.image[Ct],!0,s.maxCubemapSize):rt[Ct]=B?S.image[Ct].image:S.image[Ct],rt[Ct]=zt(S,rt[Ct]);let nt=rt[0],wt=r.convert(S.format,S.colorSpace),gt=r.convert(S.type),bt=A(S.internalFormat,wt,gt,S.normalized,S.colorSpace),Gt=S.isVideoTexture!==!0,jt=_t.__version===void 0||ht===!0,lt=ot.dataReady,Ot=w(S,nt);fe(i.TEXTURE_CUBE_MAP,S);let Jt;if(S.isDepthTexture){if(bt=_(S.format===Bs,S.type),jt)if(Gt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,bt,nt.width,nt.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,nt.width,nt.height,0,wt,gt,null)}else if(pt){Gt&&jt&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Ot,bt,nt.width,nt.height);for(let Ct=0;Ct<6;Ct++){Jt=rt[Ct].mipmaps;for(let le=0;le<Jt.length;le++){let We=Jt[le];S.format!==ji?wt!==null?Gt?lt&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le,0,0,We.width,We.height,wt,We.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le,bt,We.width,We.height,0,We.data):$t("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Gt?lt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le,0,0,We.width,We.height,wt,gt,We.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le,bt,We.width,We.height,0,wt,gt,We.data)}}}else{if(Jt=S.mipmaps,Gt&&jt){Jt.length>0&&Ot++;let Ct=qt(rt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Ot,bt,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(B){Gt?lt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,rt[Ct].width,rt[Ct].height,wt,gt,rt[Ct].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,rt[Ct].width,rt[Ct].height,0,wt,gt,rt[Ct].data);for(let le=0;le<Jt.length;le++){let jn=Jt[le].image[Ct].image;Gt?lt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le+1,0,0,jn.width,jn.height,wt,gt,jn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le+1,bt,jn.width,jn.height,0,wt,gt,jn.data)}}else{Gt?lt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,wt,gt,rt[Ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,wt,gt,rt[Ct]);for(let le=0;le<Jt.length;le++){let We=Jt[le];Gt?lt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le+1,0,0,wt,gt,We.image[Ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le+1,bt,wt,gt,We.image[Ct])}}}M(S)&&S.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),_t.__version=ot.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function Oe(R,S,q,ht,ot,_t){let yt=r.convert(q.format,q.colorSpace),et=r.convert(q.type),it=A(q.internalFormat,yt,et,q.normalized,q.colorSpace),pt=n.get(S),B=n.get(q);if(B.__renderTarget=S,!pt.__hasExternalTextures){let rt=Math.max(1,S.width>>_t),nt=Math.max(1,S.height>>_t);ot===i.TEXTURE_3D||ot===i.TEXTURE_2D_ARRAY?e.texImage3D(ot,_t,it,rt,nt,S.depth,0,yt,et,null):e.texImage2D(ot,_t,it,rt,nt,0,yt,et,null)}e.bindFramebuffer(i.FRAMEBUFFER,R),Mt(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ht,ot,B.__webglTexture,0,ae(S)):(ot===i.TEXTURE_2D||ot>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ot<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ht,ot,B.__webglTexture,_t),e.bindFramebuffer(i.FRAMEBUFFER,null)}function Ln(R,S,q){if(i.bindRenderbuffer(i.RENDERBUFFER,R),S.depthBuffer){let ht=S.depthTexture,ot=ht&&ht.isDepthTexture?ht.type:null,_t=_(S.stencilBuffer,ot),yt=S.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Mt(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ae(S),_t,S.width,S.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,ae(S),_t,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,_t,S.width,S.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,yt,i.RENDERBUFFER,R)}else{let ht=S.textures;for(let ot=0;ot<ht.length;ot++){let _t=ht[ot],yt=r.convert(_t.format,_t.colorSpace),et=r.convert(_t.type),it=A(_t.internalFormat,yt,et,_t.normalized,_t.colorSpace);Mt(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ae(S),it,S.width,S.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,ae(S),it,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,it,S.width,S.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Se(R,S,q){let ht=S.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,R),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ot=n.get(S.depthTexture);ot.__renderTarget=S;let _t=ht?S.depthTexture.image[0]:S.depthTexture.image;(!ot.__webglTexture||_t.width!==S.width||_t.height!==S.height)&&(_t.width=S.width,_t.height=S.height,S.depthTexture.needsUpdate=!0),ht?St(S.depthTexture,0):mt(S.depthTexture,0);let yt=ot.__webglTexture,et=ae(S),it=ht?i.TEXTURE_CUBE_MAP_POSITIVE_X+q:i.TEXTURE_2D,pt=S.depthTexture.format===Bs?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(S.depthTexture.format===Ns)Mt(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pt,it,yt,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,pt,it,yt,0);else if(S.depthTexture.format===Bs)Mt(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pt,it,yt,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,pt,it,yt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Sn(R){let S=n.get(R),q=R.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==R.depthTexture){let ht=R.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),ht){let ot=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,ht.removeEventListener("dispose",ot)};ht.addEventListener("dispose",ot),S.__depthDisposeCallback=ot}S.__boundDepthTexture=ht}if(R.depthTexture&&!S.__autoAllocateDepthBuffer)if(q)for(let ht=0;ht<6;ht++)Se(S.__webglFramebuffer[ht],R,ht);else R.texture.mipmaps.length>0?Se(S.__webglFramebuffer[0],R,0):Se(S.__webglFramebuffer,R,0);else if(q){S.__webglDepthbuffer=[];for(let ht=0;ht<6;ht++)if(e.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[ht]),S.__webglDepthbuffer[ht]===void 0)S.__webglDepthbuffer[ht]=i.createRenderbuffer(),Ln(S.__webglDepthbuffer[ht],R,!1);else{let ot=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_t=S.__webglDepthbuffer[ht];i.bindRenderbuffer(i.RENDERBUFFER,_t),i.framebufferRenderbuffer(i.FRAMEBUFFER,ot,i.RENDERBUFFER,_t)}}else if(R.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=i.createRenderbuffer(),Ln(S.__webglDepthbuffer,R,!1);else{let ot=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_t=S.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,_t),i.framebufferRenderbuffer(i.FRAMEBUFFER,ot,i.RENDERBUFFER,_t)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function sn(R,S,q){let ht=n.get(R);S!==void 0&&Oe(ht.__webglFramebuffer,R,R.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),q!==void 0&&Sn(R)}function mn(R){let S=R.texture,q=n.get(R),ht=n.get(S);R.addEventListener("dispose",V),U(R);let ot=R.textures,_t=R.isWebGLCubeRenderTarget===!0,yt=ot.length>1;if(yt||(ht.__webglTexture===void 0&&(ht.__webglTexture=i.createTexture()),ht.__version=S.version,o.memory.textures++),_t){q.__webglFramebuffer=[];for(let et=0;et<6;et++)if(S.mipmaps.length>0){q.__webglFramebuffer[et]=[];for(let it=0;it<S.mipmaps.length;it++)q.__webglFramebuffer[et][it]=i.createFramebuffer()}else q.__webglFramebuffer[et]=i.createFramebuffer()}else{if(S.mipmaps.length>0){q.__webglFramebuffer=[];for(let et=0;et<S.mipmaps.length;et++)q.__webglFramebuffer[et]=i.createFramebuffer()}else q.__webglFramebuffer=i.createFramebuffer();if(yt)for(let et=0,it=ot.length;et<it;et++){let pt=n.get(ot[et]);pt.__webglTexture===void 0&&(pt.__webglTexture=i.createTexture(),o.memory.textures++)}if(R.samples>0&&Mt(R)===!1){q.__webglMultisampledFramebuffer=i.createFramebuffer(),q.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let et=0;et<ot.length;et++){let it=ot[et];q.__webglColorRenderbuffer[et]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,q.__webglColorRenderbuffer[et]);let pt=r.convert(it.format,it.colorSpace),B=r.convert(it.type),rt=A(it.internalFormat,pt,B,it.normalized,it.colorSpace,R.isXRRenderTarget===!0),nt=ae(R);i.renderbufferStorageMultisample(i.RENDERBUFFER,nt,rt,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+et,i.RENDERBUFFER,q.__webglColorRenderbuffer[et])}i.bindRenderbuffer(i.RENDERBUFFER,null),R.depthBuffer&&(q.__webglDepthRenderbuffer=i.createRenderbuffer(),Ln(q.__webglDepthRenderbuffer,R,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(_t){e.bindTexture(i.TEXTURE_CUBE_MAP,ht.__webglTexture),fe(i.TEXTURE_CUBE_MAP,S);for(let et=0;et<6;et++)if(S.mipmaps.length>0)for(let it=0;it<S.mipmaps.length;it++)Oe(q.__webglFramebuffer[et][it],R,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+et,it);else Oe(q.__webglFramebuffer[et],R,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+et,0);M(S)?b(i.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),e.unbindTexture()}else if(yt){for(let et=0,it=ot.length;et<it;et++){let pt=ot[et],B=n.get(pt),rt=i.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(rt=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(rt,B.__webglTexture),fe(rt,pt),Oe(q.__webglFramebuffer,R,pt,i.COLOR_ATTACHMENT0+et,rt,0),M(pt)&&b(rt)}e.unbindTexture()}else{let et=i.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(et=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(et,ht.__webglTexture),fe(et,S),S.mipmaps.length>0)for(let it=0;it<S.mipmaps.length;it++)Oe(q.__webglFramebuffer[it],R,S,i.COLOR_ATTACHMENT0,et,it);else Oe(q.__webglFramebuffer,R,S,i.COLOR_ATTACHMENT0,et,0);M(S)?b(et):S.mipmaps.length>0&&i.texParameteri(et,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),e.unbindTexture()}R.depthBuffer&&Sn(R)}function k(R){let S=R.textures;for(let q=0,ht=S.length;q<ht;q++){let ot=S[q];if(M(ot)&&ot.mipmapsAutoUpdate===!0){let _t=C(R),yt=n.get(ot).__webglTexture;e.bindTexture(_t,yt),b(_t),e.unbindTexture()}}}let Rt=[];function Yt(R){if(R.samples>0){if(Mt(R)===!1){let S=R.textures,q=R.width,ht=R.height,ot=i.COLOR_BUFFER_BIT,_t=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,yt=n.get(R),et=S.length>1;if(et)for(let pt=0;pt<S.length;pt++)e.bindFramebuffer(i.FRAMEBUFFER,yt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,yt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,yt.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,yt.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,yt.__webglFramebuffer);for(let pt=0;pt<S.length;pt++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(ot|=i.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(ot|=i.STENCIL_BUFFER_BIT)),et){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,yt.__webglColorRenderbuffer[pt]);let B=n.get(S[pt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,B,0)}i.blitFramebuffer(0,0,q,ht,0,0,q,ht,ot,i.NEAREST),l===!0&&(Rt.length=0,Rt.push(i.COLOR_ATTACHMENT0+pt),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Rt.push(_t),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Rt))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),et)for(let pt=0;pt<S.length;pt++){e.bindFramebuffer(i.FRAMEBUFFER,yt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pt,i.RENDERBUFFER,yt.__webglColorRenderbuffer[pt]);let B=n.get(S[pt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,yt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pt,i.TEXTURE_2D,B,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,yt.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let S=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[S])}}}function ae(R){return Math.min(s.maxSamples,R.samples)}function Mt(R){let S=n.get(R);return R.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function ke(R){let S=o.render.frame;h.get(R)!==S&&(h.set(R,S),R.update())}function zt(R,S){let q=R.colorSpace,ht=R.format,ot=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||q!==_a&&q!==ks&&(ye.getTransfer(q)===Le?(ht!==ji||ot!==fi)&&$t("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ee("WebGLTextures: Unsupported texture color space:",q)),S}function qt(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=ut,this.resetTextureUnits=Q,this.getTextureUnits=st,this.setTextureUnits=dt,this.setTexture2D=mt,this.setTexture2DArray=xt,this.setTexture3D=At,this.setTextureCube=St,this.rebindTextures=sn,this.setupRenderTarget=mn,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=Yt,this.setupDepthRenderbuffer=Sn,this.setupFrameBufferTexture=Oe,this.useMultisampledRTT=Mt,this.dispose=X}function qM(i,t){function e(n,s=ks){let r,o=ye.getTransfer(s);if(n===fi)return i.UNSIGNED_BYTE;if(n===Wc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Xc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Bd)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===kd)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Ud)return i.BYTE;if(n===Od)return i.SHORT;if(n===Fo)return i.UNSIGNED_SHORT;if(n===Hc)return i.INT;if(n===Yi)return i.UNSIGNED_INT;if(n===Zi)return i.FLOAT;if(n===Ki)return i.HALF_FLOAT;if(n===zd)return i.ALPHA;if(n===Vd)return i.RGB;if(n===ji)return i.RGBA;if(n===Ns)return i.DEPTH_COMPONENT;if(n===Bs)return i.DEPTH_STENCIL;if(n===Gd)return i.RED;if(n===qc)return i.RED_INTEGER;if(n===ur)return i.RG;if(n===$c)return i.RG_INTEGER;if(n===Yc)return i.RGBA_INTEGER;if(n===Wa||n===Xa||n===qa||n===$a)if(o===Le)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Wa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Xa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===qa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===$a)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Wa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Xa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===qa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===$a)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Zc||n===Kc||n===jc||n===Jc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Zc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Kc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===jc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Jc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Qc||n===th||n===eh||n===nh||n===ih||n===Ya||n===sh)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Qc||n===th)return o===Le?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===eh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===nh)return r.COMPRESSED_R11_EAC;if(n===ih)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ya)return r.COMPRESSED_RG11_EAC;if(n===sh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===rh||n===oh||n===ah||n===lh||n===ch||n===hh||n===uh||n===dh||n===fh||n===ph||n===mh||n===gh||n===_h||n===xh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===rh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===oh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===ah)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===lh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ch)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===hh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===uh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===dh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===fh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===ph)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===mh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===gh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===_h)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===xh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===yh||n===vh||n===bh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===yh)return o===Le?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===vh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===bh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Sh||n===Mh||n===Za||n===wh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Sh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Mh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Za)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===wh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Rr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var $M=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,YM=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,hf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new Ca(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new kn({vertexShader:$M,fragmentShader:YM,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Ke(new La(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},uf=class extends qi{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,m=null,v=typeof XRWebGLBinding<"u",g=new hf,p={},y=e.getContextAttributes(),M=null,b=null,C=[],A=[],_=new Xt,w=null,U=null,F=new Mi;F.viewport=new Ie;let I=new Mi;I.viewport=new Ie;let V=[F,I],H=new Bc,N=null,X=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let mt=C[tt];return mt===void 0&&(mt=new Ao,C[tt]=mt),mt.getTargetRaySpace()},this.getControllerGrip=function(tt){let mt=C[tt];return mt===void 0&&(mt=new Ao,C[tt]=mt),mt.getGripSpace()},this.getHand=function(tt){let mt=C[tt];return mt===void 0&&(mt=new Ao,C[tt]=mt),mt.getHandSpace()};function Y(tt){let mt=A.indexOf(tt.inputSource);if(mt===-1)return;let xt=C[mt];xt!==void 0&&(xt.update(tt.inputSource,tt.frame,c||o),xt.dispatchEvent({type:tt.type,data:tt.inputSource}))}function W(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",W),s.removeEventListener("inputsourceschange",ct);for(let tt=0;tt<C.length;tt++){let mt=A[tt];mt!==null&&(A[tt]=null,C[tt].disconnect(mt))}N=null,X=null,g.reset();for(let tt in p)delete p[tt];if(t.setRenderTarget(M),f=null,d=null,u=null,s=null,b=null,ut.stop(),n.isPresenting=!1,t.setPixelRatio(w),t.setSize(_.width,_.height,!1),U!==null){let tt=U.camera;tt.fov=U.fov,tt.zoom=U.zoom,tt.updateProjectionMatrix(),U=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,n.isPresenting===!0&&$t("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,n.isPresenting===!0&&$t("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(tt){c=tt},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&v&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(M=t.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",W),s.addEventListener("inputsourceschange",ct),y.xrCompatible!==!0&&await e.makeXRCompatible(),w=t.getPixelRatio(),t.getSize(_),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let xt=null,At=null,St=null;y.depth&&(St=y.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,xt=y.stencil?Bs:Ns,At=y.stencil?Rr:Yi);let Ht={colorFormat:e.RGBA8,depthFormat:St,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Ht),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),b=new wi(d.textureWidth,d.textureHeight,{format:ji,type:fi,depthTexture:new Us(d.textureWidth,d.textureHeight,At,void 0,void 0,void 0,void 0,void 0,void 0,xt),stencilBuffer:y.stencil,colorSpace:t.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let xt={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,xt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new wi(f.framebufferWidth,f.framebufferHeight,{format:ji,type:fi,colorSpace:t.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ut.setContext(s),ut.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function ct(tt){for(let mt=0;mt<tt.removed.length;mt++){let xt=tt.removed[mt],At=A.indexOf(xt);At>=0&&(A[At]=null,C[At].disconnect(xt))}for(let mt=0;mt<tt.added.length;mt++){let xt=tt.added[mt],At=A.indexOf(xt);if(At===-1){for(let Ht=0;Ht<C.length;Ht++)if(Ht>=A.length){A.push(xt),At=Ht;break}else if(A[Ht]===null){A[Ht]=xt,At=Ht;break}if(At===-1)break}let St=C[At];St&&St.connect(xt)}}function j(tt,mt){mt===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(mt.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let mt=tt.near,xt=tt.far;g.texture!==null&&(g.depthNear>0&&(mt=g.depthNear),g.depthFar>0&&(xt=g.depthFar)),H.near=I.near=F.near=mt,H.far=I.far=F.far=xt,(N!==H.near||X!==H.far)&&(s.updateRenderState({depthNear:H.near,depthFar:H.far}),N=H.near,X=H.far),H.layers.mask=tt.layers.mask|6,F.layers.mask=H.layers.mask&-5,I.layers.mask=H.layers.mask&-3;let At=tt.parent,St=H.cameras;j(H,At);for(let Ht=0;Ht<St.length;Ht++)j(St[Ht],At);H.projectionMatrix.copy(F.projectionMatrix),H.projectionMatrixInverse.copy(F.projectionMatrixInverse),U===null&&tt.isPerspectiveCamera&&(U={camera:tt,fov:tt.fov,zoom:tt.zoom}),Q(tt,H,At)};function Q(tt,mt,xt){xt===null?tt.matrix.copy(mt.matrixWorld):(tt.matrix.copy(xt.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(mt.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(mt.projectionMatrix),tt.projectionMatrixInverse.copy(mt.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=To*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(tt){l=tt,d!==null&&(d.fixedFoveation=tt),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=tt)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(H)},this.getCameraTexture=function(tt){return p[tt]};let st=null;function dt(tt,mt){if(h=mt.getViewerPose(c||o),m=mt,h!==null){let xt=h.views;f!==null&&(t.setRenderTargetFramebuffer(b,f.framebuffer),t.setRenderTarget(b));let At=!1;xt.length!==H.cameras.length&&(H.cameras.length=0,At=!0);for(let Vt=0;Vt<xt.length;Vt++){let fe=xt[Vt],he=null;if(f!==null)he=f.getViewport(fe);else{let Je=u.getViewSubImage(d,fe);he=Je.viewport,Vt===0&&(t.setRenderTargetTextures(b,Je.colorTexture,Je.depthStencilTexture),t.setRenderTarget(b))}let ie=V[Vt];ie===void 0&&(ie=new Mi,ie.layers.enable(Vt),ie.viewport=new Ie,V[Vt]=ie),ie.matrix.fromArray(fe.transform.matrix),ie.matrix.decompose(ie.position,ie.quaternion,ie.scale),ie.projectionMatrix.fromArray(fe.projectionMatrix),ie.projectionMatrixInverse.copy(ie.projectionMatrix).invert(),ie.viewport.set(he.x,he.y,he.width,he.height),Vt===0&&(H.matrix.copy(ie.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),At===!0&&H.cameras.push(ie)}let St=s.enabledFeatures;if(St&&St.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){u=n.getBinding();let Vt=u.getDepthInformation(xt[0]);Vt&&Vt.isValid&&Vt.texture&&g.init(Vt,s.renderState)}if(St&&St.includes("camera-access")&&v){t.state.unbindTexture(),u=n.getBinding();for(let Vt=0;Vt<xt.length;Vt++){let fe=xt[Vt].camera;if(fe){let he=p[fe];he||(he=new Ca,p[fe]=he);let ie=u.getCameraImage(fe);he.sourceTexture=ie}}}}for(let xt=0;xt<C.length;xt++){let At=A[xt],St=C[xt];At!==null&&St!==void 0&&St.update(At,mt,c||o)}st&&st(tt,mt),mt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:mt}),m=null}let ut=new gg;ut.setAnimationLoop(dt),this.setAnimationLoop=function(tt){st=tt},this.dispose=function(){}}},ZM=new be,Eg=new ne;Eg.set(-1,0,0,0,1,0,0,0,1);function KM(i,t){function e(g,p){g.matrixAutoUpdate===!0&&g.updateMatrix(),p.value.copy(g.matrix)}function n(g,p){p.color.getRGB(g.fogColor.value,jd(i)),p.isFog?(g.fogNear.value=p.near,g.fogFar.value=p.far):p.isFogExp2&&(g.fogDensity.value=p.density)}function s(g,p,y,M,b){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(g,p):p.isMeshLambertMaterial?(r(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(g,p),u(g,p)):p.isMeshPhongMaterial?(r(g,p),h(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(g,p),d(g,p),p.isMeshPhysicalMaterial&&f(g,p,b)):p.isMeshMatcapMaterial?(r(g,p),m(g,p)):p.isMeshDepthMaterial?r(g,p):p.isMeshDistanceMaterial?(r(g,p),v(g,p)):p.isMeshNormalMaterial?r(g,p):p.isLineBasicMaterial?(o(g,p),p.isLineDashedMaterial&&a(g,p)):p.isPointsMaterial?l(g,p,y,M):p.isSpriteMaterial?c(g,p):p.isShadowMaterial?(g.color.value.copy(p.color),g.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(g,p){g.opacity.value=p.opacity,p.color&&g.diffuse.value.copy(p.color),p.emissive&&g.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(g.map.value=p.map,e(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.bumpMap&&(g.bumpMap.value=p.bumpMap,e(p.bumpMap,g.bumpMapTransform),g.bumpScale.value=p.bumpScale,p.side===oi&&(g.bumpScale.value*=-1)),p.normalMap&&(g.normalMap.value=p.normalMap,e(p.normalMap,g.normalMapTransform),g.normalScale.value.copy(p.normalScale),p.side===oi&&g.normalScale.value.negate()),p.displacementMap&&(g.displacementMap.value=p.displacementMap,e(p.displacementMap,g.displacementMapTransform),g.displacementScale.value=p.displacementScale,g.displacementBias.value=p.displacementBias),p.emissiveMap&&(g.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,g.emissiveMapTransform)),p.specularMap&&(g.specularMap.value=p.specularMap,e(p.specularMap,g.specularMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest);let y=t.get(p),M=y.envMap,b=y.envMapRotation;M&&(g.envMap.value=M,g.envMapRotation.value.setFromMatrix4(ZM.makeRotationFromEuler(b)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Eg),g.reflectivity.value=p.reflectivity,g.ior.value=p.ior,g.refractionRatio.value=p.refractionRatio),p.lightMap&&(g.lightMap.value=p.lightMap,g.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,g.lightMapTransform)),p.aoMap&&(g.aoMap.value=p.aoMap,g.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,g.aoMapTransform))}function o(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,p.map&&(g.map.value=p.map,e(p.map,g.mapTransform))}function a(g,p){g.dashSize.value=p.dashSize,g.totalSize.value=p.dashSize+p.gapSize,g.scale.value=p.scale}function l(g,p,y,M){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.size.value=p.size*y,g.scale.value=M*.5,p.map&&(g.map.value=p.map,e(p.map,g.uvTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function c(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.rotation.value=p.rotation,p.map&&(g.map.value=p.map,e(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function h(g,p){g.specular.value.copy(p.specular),g.shininess.value=Math.max(p.shininess,1e-4)}function u(g,p){p.gradientMap&&(g.gradientMap.value=p.gradientMap)}function d(g,p){g.metalness.value=p.metalness,p.metalnessMap&&(g.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,g.metalnessMapTransform)),g.roughness.value=p.roughness,p.roughnessMap&&(g.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,g.roughnessMapTransform)),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)}function f(g,p,y){g.ior.value=p.ior,p.diffuseRoughness>0&&(g.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=p.diffuseRoughnessMap,e(p.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),p.sheen>0&&(g.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),g.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(g.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,g.sheenColorMapTransform)),p.sheenRoughnessMap&&(g.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,g.sheenRoughnessMapTransform))),p.clearcoat>0&&(g.clearcoat.value=p.clearcoat,g.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(g.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,g.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(g.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===oi&&g.clearcoatNormalScale.value.negate())),p.dispersion>0&&(g.dispersion.value=p.dispersion),p.retroreflectivity>0&&(g.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(g.iridescence.value=p.iridescence,g.iridescenceIOR.value=p.iridescenceIOR,g.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(g.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,g.iridescenceMapTransform)),p.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),p.transmission>0&&(g.transmission.value=p.transmission,g.transmissionSamplerMap.value=y.texture,g.transmissionSamplerSize.value.set(y.width,y.height),p.transmissionMap&&(g.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,g.transmissionMapTransform)),g.thickness.value=p.thickness,p.thicknessMap&&(g.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=p.attenuationDistance,g.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(g.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(g.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=p.specularIntensity,g.specularColor.value.copy(p.specularColor),p.specularColorMap&&(g.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,g.specularColorMapTransform)),p.specularIntensityMap&&(g.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,p){p.matcap&&(g.matcap.value=p.matcap)}function v(g,p){let y=t.get(p).light;g.referencePosition.value.setFromMatrixPosition(y.matrixWorld),g.nearDistance.value=y.shadow.camera.near,g.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function jM(i,t,e,n){let s={},r={};function o(y,M){let b=M.program;n.uniformBlockBinding(y,b,s[y.id])}function a(y,M){let b=s[y.id];b===void 0&&(m(y),b=l(y),s[y.id]=b,y.addEventListener("dispose",g));let C=M.program;n.updateUBOMapping(y,C);let A=t.render.frame;r[y.id]!==A&&(c(y),r[y.id]=A)}function l(y){let M=i.createBuffer(),b=y.__size,C=y.usage;return i.bindBuffer(i.UNIFORM_BUFFER,M),i.bufferData(i.UNIFORM_BUFFER,b,C),i.bindBuffer(i.UNIFORM_BUFFER,null),M}function c(y){let M=s[y.id],b=y.uniforms,C=y.__cache;i.bindBuffer(i.UNIFORM_BUFFER,M);for(let A=0,_=b.length;A<_;A++){let w=b[A];if(Array.isArray(w))for(let U=0,F=w.length;U<F;U++)h(w[U],A,U,C);else h(w,A,0,C)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(y,M,b,C){if(d(y,M,b,C)===!0){let A=y.__offset,_=y.value;if(Array.isArray(_)){let w=0;for(let U=0;U<_.length;U++){let F=_[U],I=v(F,!0);u(F,y.__data,w),w+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else u(_,y.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,A,y.__data)}}function u(y,M,b){typeof y=="number"||typeof y=="boolean"?M[b]=y:y.isMatrix3?(M[b]=y.elements[0],M[b+1]=y.elements[1],M[b+2]=y.elements[2],M[b+3]=0,M[b+4]=y.elements[3],M[b+5]=y.elements[4],M[b+6]=y.elements[5],M[b+7]=0,M[b+8]=y.elements[6],M[b+9]=y.elements[7],M[b+10]=y.elements[8],M[b+11]=0):ArrayBuffer.isView(y)?M.set(y.subarray(0,M.length-b),b):y.toArray(M,b)}function d(y,M,b,C){let A=y.value,_=M+"_"+b;if(Array.isArray(A)){C[_]===void 0&&(C[_]=[]);let w=C[_],U=!1;for(let F=0;F<A.length;F++)f(A[F],w,F)===!0&&(U=!0);return U}return f(A,C,_)}function f(y,M,b){if(M[b]===void 0)return typeof y=="number"||typeof y=="boolean"?M[b]=y:ArrayBuffer.isView(y)?M[b]=y.slice():M[b]=y.clone(),!0;{let C=M[b];if(typeof y=="number"||typeof y=="boolean"){if(C!==y)return M[b]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(C.equals(y)===!1)return C.copy(y),!0}}return!1}function m(y){let M=y.uniforms,b=0,C=16;for(let _=0,w=M.length;_<w;_++){let U=Array.isArray(M[_])?M[_]:[M[_]];for(let F=0,I=U.length;F<I;F++){let V=U[F],H=Array.isArray(V.value)?V.value:[V.value],N=Array.isArray(M[_])||Array.isArray(V.value),X=b;for(let W=0,ct=H.length;W<ct;W++){let j=H[W],Q=v(j,N),st=b%C,dt=st%Q.boundary,ut=st+dt;b+=dt,ut!==0&&C-ut<Q.storage&&(b+=C-ut),W===0&&(X=b),b+=Q.storage}let Y=V.type==="int"?Int32Array:V.type==="uint"?Uint32Array:Float32Array;V.__data=new Y((b-X)/Float32Array.BYTES_PER_ELEMENT),V.__offset=X}}let A=b%C;return A>0&&(b+=C-A),y.__size=b,y.__cache={},this}function v(y,M){let b={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(b.boundary=4,b.storage=4):y.isVector2?(b.boundary=8,b.storage=8):y.isVector3||y.isColor?(b.boundary=16,b.storage=12):y.isVector4?(b.boundary=16,b.storage=16):y.isMatrix3?(b.boundary=16,b.storage=48):y.isMatrix4?(b.boundary=16,b.storage=64):y.isTexture?$t("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(b.boundary=16,b.storage=y.byteLength):$t("WebGLRenderer: Unsupported uniform value type.",y),M===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function g(y){let M=y.target;M.removeEventListener("dispose",g),i.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function p(){for(let y in s)i.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:p}}var JM=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),fs=null;function QM(){return fs===null&&(fs=new yc(JM,16,16,ur,Ki),fs.name="DFG_LUT",fs.minFilter=ri,fs.magFilter=ri,fs.wrapS=hs,fs.wrapT=hs,fs.generateMipmaps=!1,fs.needsUpdate=!0),fs}var Ph=class{constructor(t={}){let{canvas:e=Gm(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=fi}=t;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=o;let v=f,g=new Set([Yc,$c,qc]),p=new Set([fi,Yi,Fo,Rr,Wc,Xc]),y=new Uint32Array(4),M=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},C=null,A=null,_=[],w=[],U=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ds,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let F=this,I=!1,V=null,H=null,N=null,X=null;this._outputColorSpace=bi;let Y=0,W=0,ct=null,j=-1,Q=null,st=new Ie,dt=new Ie,ut=null,tt=new Zt(0),mt=0,xt=e.width,At=e.height,St=1,Ht=null,oe=null,Vt=new Ie(0,0,xt,At),fe=new Ie(0,0,xt,At),he=!1,ie=new nr,Je=new vc,Ge=!1,pn=!1,Oe=new be,Ln=new O,Se=new Ie,Sn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},sn=!1;function mn(){return ct===null?St:1}let k=n;function Rt(E,z){return e.getContext(E,z)}let Yt,ae,Mt,ke,zt,qt,R,S,q,ht,ot,_t,yt,et,it,pt,B,rt,nt,wt,gt,bt,Gt;try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Ot,!1),e.addEventListener("webglcontextrestored",Jt,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),k===null){let z="webgl2";if(k=Rt(z,E),k===null)throw Rt(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}jt()}catch(E){throw e.removeEventListener("webglcontextlost",Ot,!1),e.removeEventListener("webglcontextrestored",Jt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),ee("WebGLRenderer: "+E.message),E}function jt(){Yt=new hS(k),Yt.init(),gt=new qM(k,Yt),ae=new Qb(k,Yt,t,gt),Mt=new WM(k,Yt),ae.reversedDepthBuffer&&d&&Mt.buffers.depth.setReversed(!0),H=k.createFramebuffer(),N=k.createFramebuffer(),X=k.createFramebuffer(),ke=new fS(k),zt=new PM,qt=new XM(k,Yt,Mt,zt,ae,gt,ke),R=new cS(F),S=new my(k),bt=new jb(k,S),q=new uS(k,S,ke,bt),ht=new mS(k,q,S,bt,ke),rt=new pS(k,ae,qt),it=new tS(zt),ot=new RM(F,R,Yt,ae,bt,it),_t=new KM(F,zt),yt=new IM,et=new BM(Yt),B=new Kb(F,R,Mt,ht,m,l),pt=new HM(F,ht,ae),Gt=new jM(k,ke,ae,Mt),nt=new Jb(k,Yt,ke),wt=new dS(k,Yt,ke),ke.programs=ot.programs,F.capabilities=ae,F.extensions=Yt,F.properties=zt,F.renderLists=yt,F.shadowMap=pt,F.state=Mt,F.info=ke}v!==fi&&(U=new _S(v,e.width,e.height,a,s,r));let lt=new uf(F,k);this.xr=lt,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let E=Yt.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=Yt.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return St},this.setPixelRatio=function(E){E!==void 0&&(St=E,this.setSize(xt,At,!1))},this.getSize=function(E){return E.set(xt,At)},this.setSize=function(E,z,J=!0){if(lt.isPresenting){$t("WebGLRenderer: Can't change size while VR device is presenting.");return}xt=E,At=z,e.width=Math.floor(E*St),e.height=Math.floor(z*St),J===!0&&(e.style.width=E+"px",e.style.height=z+"px"),U!==null&&U.setSize(e.width,e.height),this.setViewport(0,0,E,z)},this.getDrawingBufferSize=function(E){return E.set(xt*St,At*St).floor()},this.setDrawingBufferSize=function(E,z,J){xt=E,At=z,St=J,e.width=Math.floor(E*J),e.height=Math.floor(z*J),this.setViewport(0,0,E,z)},this.setEffects=function(E){if(v===fi){ee("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let z=0;z<E.length;z++)if(E[z].isOutputPass===!0){$t("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(st)},this.getViewport=function(E){return E.copy(Vt)},this.setViewport=function(E,z,J,$){E.isVector4?Vt.set(E.x,E.y,E.z,E.w):Vt.set(E,z,J,$),Mt.viewport(st.copy(Vt).multiplyScalar(mn()).round())},this.getScissor=function(E){return E.copy(fe)},this.setScissor=function(E,z,J,$){E.isVector4?fe.set(E.x,E.y,E.z,E.w):fe.set(E,z,J,$),Mt.scissor(dt.copy(fe).multiplyScalar(mn()).round())},this.getScissorTest=function(){return he},this.setScissorTest=function(E){Mt.setScissorTest(he=E)},this.setOpaqueSort=function(E){Ht=E},this.setTransparentSort=function(E){oe=E},this.getClearColor=function(E){return E.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(E=!0,z=!0,J=!0){let $=0;if(E){let Z=!1;if(ct!==null){let Tt=ct.texture.format;Z=g.has(Tt)}if(Z){let Tt=ct.texture.type,Lt=p.has(Tt),Et=B.getClearColor(),It=B.getClearAlpha(),kt=Et.r,te=Et.g,pe=Et.b;Lt?(y[0]=kt,y[1]=te,y[2]=pe,y[3]=It,k.clearBufferuiv(k.COLOR,0,y)):(M[0]=kt,M[1]=te,M[2]=pe,M[3]=It,k.clearBufferiv(k.COLOR,0,M))}else $|=k.COLOR_BUFFER_BIT}z&&($|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),J&&($|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&k.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),V=E},this.dispose=function(){e.removeEventListener("webglcontextlost",Ot,!1),e.removeEventListener("webglcontextrestored",Jt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),B.dispose(),yt.dispose(),et.dispose(),qt.dispose(),zt.dispose(),R.dispose(),ht.dispose(),q.dispose(),bt.dispose(),Gt.dispose(),ot.dispose(),lt.dispose(),lt.removeEventListener("sessionstart",xl),lt.removeEventListener("sessionend",es),xs.stop()};function Ot(E){E.preventDefault(),va("WebGLRenderer: Context Lost."),I=!0}function Jt(){va("WebGLRenderer: Context Restored."),I=!1;let E=ke.autoReset,z=pt.enabled,J=pt.autoUpdate,$=pt.needsUpdate,Z=pt.type;jt(),ke.autoReset=E,pt.enabled=z,pt.autoUpdate=J,pt.needsUpdate=$,pt.type=Z}function Ct(E){ee("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function le(E){let z=E.target;z.removeEventListener("dispose",le),We(z)}function We(E){jn(E),zt.remove(E)}function jn(E){let z=zt.get(E).programs;z!==void 0&&(z.forEach(function(J){ot.releaseProgram(J)}),E.isShaderMaterial&&ot.releaseShaderCache(E))}this.renderBufferDirect=function(E,z,J,$,Z,Tt){z===null&&(z=Sn);let Lt=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Et=ea(E,z,J,$,Z);Mt.setMaterial($,Lt);let It=J.index,kt=1;if($.wireframe===!0){if(It=q.getWireframeAttribute(J),It===void 0)return;kt=2}let te=J.drawRange,pe=J.attributes.position,Bt=te.start*kt,me=(te.start+te.count)*kt;Tt!==null&&(Bt=Math.max(Bt,Tt.start*kt),me=Math.min(me,(Tt.start+Tt.count)*kt)),It!==null?(Bt=Math.max(Bt,0),me=Math.min(me,It.count)):pe!=null&&(Bt=Math.max(Bt,0),me=Math.min(me,pe.count));let nn=me-Bt;if(nn<0||nn===1/0)return;bt.setup(Z,$,Et,J,It);let Ne,Fe=nt;if(It!==null&&(Ne=S.get(It),Fe=wt,Fe.setIndex(Ne)),Z.isMesh)$.wireframe===!0?(Mt.setLineWidth($.wireframeLinewidth*mn()),Fe.setMode(k.LINES)):Fe.setMode(k.TRIANGLES);else if(Z.isLine){let Mn=$.linewidth;Mn===void 0&&(Mn=1),Mt.setLineWidth(Mn*mn()),Z.isLineSegments?Fe.setMode(k.LINES):Z.isLineLoop?Fe.setMode(k.LINE_LOOP):Fe.setMode(k.LINE_STRIP)}else Z.isPoints?Fe.setMode(k.POINTS):Z.isSprite&&Fe.setMode(k.TRIANGLES);if(Z.isBatchedMesh)if(Yt.get("WEBGL_multi_draw"))Fe.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let Mn=Z._multiDrawStarts,Ft=Z._multiDrawCounts,gn=Z._multiDrawCount,_e=It?S.get(It).bytesPerElement:1,vs=zt.get($).currentProgram.getUniforms();for(let _n=0;_n<gn;_n++)vs.setValue(k,"_gl_DrawID",_n),Fe.render(Mn[_n]/_e,Ft[_n])}else if(Z.isInstancedMesh)Fe.renderInstances(Bt,nn,Z.count);else if(J.isInstancedBufferGeometry){let Mn=J._maxInstanceCount!==void 0?J._maxInstanceCount:1/0,Ft=Math.min(J.instanceCount,Mn);Fe.renderInstances(Bt,nn,Ft)}else Fe.render(Bt,nn)};function Jo(E,z,J,$){V!==null&&E.isNodeMaterial&&V.setObject($,E),Ge===!0&&it.setState(E,J,!1),E.transparent===!0&&E.side===Ai&&E.forceSinglePass===!1?(E.side=oi,E.needsUpdate=!0,ns(E,z,$),E.side=hr,E.needsUpdate=!0,ns(E,z,$),E.side=Ai):ns(E,z,$)}this.compile=function(E,z,J=null){J===null&&(J=E),V!==null&&V.renderStart(E,z,J),A=et.get(J),A.init(z),w.push(A),J.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),E!==J&&E.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),A.setupLights(),V!==null&&V.updateLights(A.state.lightsArray),pn=this.localClippingEnabled,Ge=it.init(this.clippingPlanes,pn),Ge===!0&&it.setGlobalState(this.clippingPlanes,z),V!==null&&pt.render(A.state.shadowsArray,J,z);let $=new Set;return E.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Tt=Z.material;if(Tt)if(Array.isArray(Tt))for(let Lt=0;Lt<Tt.length;Lt++){let Et=Tt[Lt];Jo(Et,J,z,Z),$.add(Et)}else Jo(Tt,J,z,Z),$.add(Tt)}),A=w.pop(),V!==null&&V.renderEnd(),$},this.compileAsync=function(E,z,J=null){let $=this.compile(E,z,J);return new Promise(Z=>{function Tt(){if($.forEach(function(Lt){let It=zt.get(Lt).currentProgram;(It===void 0||It.isReady())&&$.delete(Lt)}),$.size===0){Z(E);return}setTimeout(Tt,10)}Yt.get("KHR_parallel_shader_compile")!==null?Tt():setTimeout(Tt,10)})};let Hr=null;function Pu(E){Hr&&Hr(E)}function xl(){xs.stop()}function es(){xs.start()}let xs=new gg;xs.setAnimationLoop(Pu),typeof self<"u"&&xs.setContext(self),this.setAnimationLoop=function(E){Hr=E,lt.setAnimationLoop(E),E===null?xs.stop():xs.start()},lt.addEventListener("sessionstart",xl),lt.addEventListener("sessionend",es),this.render=function(E,z){if(z!==void 0&&z.isCamera!==!0){ee("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;V!==null&&V.renderStart(E,z);let J=lt.enabled===!0&&lt.isPresenting===!0,$=U!==null&&(ct===null||J)&&U.begin(F,ct);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),lt.enabled===!0&&lt.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(lt.cameraAutoUpdate===!0&&lt.updateCamera(z),z=lt.getCamera()),E.isScene===!0&&E.onBeforeRender(F,E,z,ct),A=et.get(E,w.length),A.init(z),A.state.textureUnits=qt.getTextureUnits(),w.push(A),Oe.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?Je.setFromArrayCamera(z):ie.setFromProjectionMatrix(Oe,Ni,z.reversedDepth),pn=this.localClippingEnabled,Ge=it.init(this.clippingPlanes,pn),C=yt.get(E,_.length),C.init(),_.push(C),this.info.render.frame++,lt.enabled===!0&&lt.isPresenting===!0){let Lt=F.xr.getDepthSensingMesh();Lt!==null&&ys(Lt,z,-1/0,F.sortObjects)}ys(E,z,0,F.sortObjects),C.finish(),V!==null&&V.updateLights(A.state.lightsArray),F.sortObjects===!0&&C.sort(Ht,oe),sn=lt.enabled===!1||lt.isPresenting===!1||lt.hasDepthSensing()===!1,sn&&B.addToRenderList(C,E),this.info.autoReset===!0&&this.info.reset(),Ge===!0&&it.beginShadows();let Z=A.state.shadowsArray;if(pt.render(Z,E,z),Ge===!0&&it.endShadows(),($&&U.hasRenderPass())===!1){let Lt=C.opaque,Et=C.transmissive;if(A.setupLights(),z.isArrayCamera){let It=z.cameras;if(Et.length>0)for(let kt=0,te=It.length;kt<te;kt++){let pe=It[kt];ki(Lt,Et,E,pe)}sn&&B.render(E);for(let kt=0,te=It.length;kt<te;kt++){let pe=It[kt];Qo(C,E,pe,pe.viewport)}}else Et.length>0&&ki(Lt,Et,E,z),sn&&B.render(E),Qo(C,E,z)}ct!==null&&W===0&&(qt.updateMultisampleRenderTarget(ct),qt.updateRenderTargetMipmap(ct)),$&&U.end(F),E.isScene===!0&&E.onAfterRender(F,E,z),bt.resetDefaultState(),j=-1,Q=null,w.pop(),w.length>0?(A=w[w.length-1],qt.setTextureUnits(A.state.textureUnits),Ge===!0&&it.setGlobalState(F.clippingPlanes,A.state.camera)):A=null,_.pop(),_.length>0?C=_[_.length-1]:C=null,V!==null&&V.renderEnd()};function ys(E,z,J,$){if(E.visible===!1)return;if(E.layers.test(z.layers)){if(E.isGroup)J=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(z);else if(E.isLight)A.pushLight(E),E.castShadow&&A.pushShadow(E);else if(E.isSprite){let Lt=z.isArrayCamera?Je:ie;if(!E.frustumCulled||E.intersectsFrustum(Lt)){$&&Se.setFromMatrixPosition(E.matrixWorld).applyMatrix4(Oe);let Et=ht.update(E),It=E.material;It.visible&&C.push(E,Et,It,J,Se.z,null,z)}}else if(E.isMesh||E.isLine||E.isPoints){let Lt=z.isArrayCamera?Je:ie;if(!E.frustumCulled||E.intersectsFrustum(Lt)){let Et=ht.update(E),It=E.material;if($&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),Se.copy(E.boundingSphere.center)):(Et.boundingSphere===null&&Et.computeBoundingSphere(),Se.copy(Et.boundingSphere.center)),Se.applyMatrix4(E.matrixWorld).applyMatrix4(Oe)),Array.isArray(It)){let kt=Et.groups;for(let te=0,pe=kt.length;te<pe;te++){let Bt=kt[te],me=It[Bt.materialIndex];me&&me.visible&&C.push(E,Et,me,J,Se.z,Bt,z)}}else It.visible&&C.push(E,Et,It,J,Se.z,null,z)}}}let Tt=E.children;for(let Lt=0,Et=Tt.length;Lt<Et;Lt++)ys(Tt[Lt],z,J,$)}function Qo(E,z,J,$){let{opaque:Z,transmissive:Tt,transparent:Lt}=E;A.setupLightsView(J),Ge===!0&&it.setGlobalState(F.clippingPlanes,J),$&&Mt.viewport(st.copy($)),Z.length>0&&rn(Z,z,J),Tt.length>0&&rn(Tt,z,J),Lt.length>0&&rn(Lt,z,J),Mt.buffers.depth.setTest(!0),Mt.buffers.depth.setMask(!0),Mt.buffers.color.setMask(!0),Mt.setPolygonOffset(!1)}function ki(E,z,J,$){if((J.isScene===!0?J.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[$.id]===void 0){let Bt=Yt.has("EXT_color_buffer_half_float")||Yt.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[$.id]=new wi(1,1,{generateMipmaps:!0,type:Bt?Ki:fi,minFilter:Os,samples:Math.max(4,ae.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:ye.workingColorSpace})}let Tt=A.state.transmissionRenderTarget[$.id],Lt=$.viewport||st;Tt.setSize(Lt.z*F.transmissionResolutionScale,Lt.w*F.transmissionResolutionScale);let Et=F.getRenderTarget(),It=F.getActiveCubeFace(),kt=F.getActiveMipmapLevel();F.setRenderTarget(Tt),F.getClearColor(tt),mt=F.getClearAlpha(),mt<1&&F.setClearColor(16777215,.5),F.clear(),sn&&B.render(J);let te=F.toneMapping;F.toneMapping=ds;let pe=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),A.setupLightsView($),Ge===!0&&it.setGlobalState(F.clippingPlanes,$),rn(E,J,$),qt.updateMultisampleRenderTarget(Tt),qt.updateRenderTargetMipmap(Tt),Yt.has("WEBGL_multisampled_render_to_texture")===!1){let Bt=!1;for(let me=0,nn=z.length;me<nn;me++){let Ne=z[me],{object:Fe,geometry:Mn,material:Ft,group:gn}=Ne;if(Ft.side===Ai&&Fe.layers.test($.layers)){let _e=Ft.side;Ft.side=oi,Ft.needsUpdate=!0,cn(Fe,J,$,Mn,Ft,gn),Ft.side=_e,Ft.needsUpdate=!0,Bt=!0}}Bt===!0&&(qt.updateMultisampleRenderTarget(Tt),qt.updateRenderTargetMipmap(Tt))}F.setRenderTarget(Et,It,kt),F.setClearColor(tt,mt),pe!==void 0&&($.viewport=pe),F.toneMapping=te}function rn(E,z,J){let $=z.isScene===!0?z.overrideMaterial:null;for(let Z=0,Tt=E.length;Z<Tt;Z++){let Lt=E[Z],{object:Et,geometry:It,group:kt}=Lt,te=Lt.material;te.allowOverride===!0&&$!==null&&(te=$),Et.layers.test(J.layers)&&cn(Et,z,J,It,te,kt)}}function cn(E,z,J,$,Z,Tt){V!==null&&Z.isNodeMaterial&&V.setObject(E,Z),E.onBeforeRender(F,z,J,$,Z,Tt),E.modelViewMatrix.multiplyMatrices(J.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),Z.onBeforeRender(F,z,J,$,E,Tt),Z.transparent===!0&&Z.side===Ai&&Z.forceSinglePass===!1?(Z.side=oi,Z.needsUpdate=!0,F.renderBufferDirect(J,z,$,Z,E,Tt),Z.side=hr,Z.needsUpdate=!0,F.renderBufferDirect(J,z,$,Z,E,Tt),Z.side=Ai):F.renderBufferDirect(J,z,$,Z,E,Tt),E.onAfterRender(F,z,J,$,Z,Tt)}function hn(E){let z=0;for(let J of E)J.texture!==null&&z++;return z}function ns(E,z,J){z.isScene!==!0&&(z=Sn);let $=zt.get(E),Z=A.state.lights,Tt=A.state.shadowsArray,Lt=Z.state.version,Et=ot.getParameters(E,Z.state,Tt,z,J,A.state.lightProbeGridArray),It=ot.getProgramCacheKey(Et),kt=$.programs;$.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?z.environment:null,$.fog=z.fog;let te=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;$.envMap=R.get(E.envMap||$.environment,te),$.envMapRotation=$.environment!==null&&E.envMap===null?z.environmentRotation:E.envMapRotation,kt===void 0&&(E.addEventListener("dispose",le),kt=new Map,$.programs=kt,$.programVariants=new Map);let pe=kt.get(It);if(pe!==void 0){if($.currentProgram===pe&&$.lightsStateVersion===Lt)return ta(E,Et),pe}else Et.uniforms=ot.getUniforms(E),V!==null&&E.isNodeMaterial&&V.build(E,J,Et),E.onBeforeCompile(Et,F),pe=ot.acquireProgram(Et,It),kt.set(It,pe),$.uniforms=Et.uniforms;let Bt=$.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(Bt.clippingPlanes=it.uniform),ta(E,Et),$.needsLights=Xs(E),$.lightsStateVersion=Lt,$.needsLights&&(Bt.ambientLightColor.value=Z.state.ambient,Bt.lightProbe.value=Z.state.probe,Bt.sunLights.value=Z.state.sun,Bt.sunLightShadows.value=Z.state.sunShadow,Bt.directionalLights.value=Z.state.directional,Bt.directionalLightShadows.value=Z.state.directionalShadow,Bt.spotLights.value=Z.state.spot,Bt.spotLightShadows.value=Z.state.spotShadow,Bt.rectAreaLights.value=Z.state.rectArea,Bt.ltc_1.value=Z.state.rectAreaLTC1,Bt.ltc_2.value=Z.state.rectAreaLTC2,Bt.pointLights.value=Z.state.point,Bt.pointLightShadows.value=Z.state.pointShadow,Bt.hemisphereLights.value=Z.state.hemi,Bt.sunShadowMatrix.value=Z.state.sunShadowMatrix,Bt.sunShadowCascade.value=Z.state.sunShadowCascade,Bt.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,Bt.spotLightMatrix.value=Z.state.spotLightMatrix,Bt.spotLightMap.value=Z.state.spotLightMap,Bt.pointShadowMatrix.value=Z.state.pointShadowMatrix),$.numLightProbeGrids=hn(A.state.lightProbeGridArray),$.currentProgram=pe,$.uniformsList=null,pe}function mi(E,z,J,$,Z){let Tt=zt.get(E),Lt=Tt.currentProgram.id+","+$+","+Z,Et=Tt.programVariants.get(Lt);return Et===void 0?(Et=ns(E,z,J),Tt.programVariants.set(Lt,Et)):(Tt.currentProgram=Et,Tt.uniformsList=null,Tt.outputColorSpace=$,Tt.toneMapping=Z),Et}function Ws(E){if(E.uniformsList===null){let z=E.currentProgram.getUniforms();E.uniformsList=Uo.seqWithValue(z.seq,E.uniforms)}return E.uniformsList}function ta(E,z){let J=zt.get(E);J.outputColorSpace=z.outputColorSpace,J.batching=z.batching,J.batchingColor=z.batchingColor,J.instancing=z.instancing,J.instancingColor=z.instancingColor,J.instancingMorph=z.instancingMorph,J.skinning=z.skinning,J.morphTargets=z.morphTargets,J.morphNormals=z.morphNormals,J.morphColors=z.morphColors,J.morphTargetsCount=z.morphTargetsCount,J.numClippingPlanes=z.numClippingPlanes,J.numIntersection=z.numClipIntersection,J.vertexAlphas=z.vertexAlphas,J.vertexTangents=z.vertexTangents,J.toneMapping=z.toneMapping}function ea(E,z,J,$,Z){z.isScene!==!0&&(z=Sn),qt.resetTextureUnits();let Tt=z.fog,Lt=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?z.environment:null,Et=ct===null?F.outputColorSpace:ct.isXRRenderTarget===!0?ct.texture.colorSpace:ye.workingColorSpace,It=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,kt=R.get($.envMap||Lt,It),te=$.vertexColors===!0&&!!J.attributes.color&&J.attributes.color.itemSize===4,pe=!!J.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),Bt=!!J.morphAttributes.position,me=!!J.morphAttributes.normal,nn=!!J.morphAttributes.color,Ne=ds;$.toneMapped&&(ct===null||ct.isXRRenderTarget===!0)&&(Ne=F.toneMapping);let Fe=J.morphAttributes.position||J.morphAttributes.normal||J.morphAttributes.color,Mn=Fe!==void 0?Fe.length:0,Ft=zt.get($),gn=A.state.lights;if(Ge===!0&&(pn===!0||E!==Q)){let Ue=E===Q&&$.id===j;it.setState($,E,Ue)}let _e=!1,vs=!1;$.version===Ft.__version?Ft.needsLights&&Ft.lightsStateVersion!==gn.state.version||Z.isBatchedMesh&&Ft.batching===!1||!Z.isBatchedMesh&&Ft.batching===!0||Z.isBatchedMesh&&Ft.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Ft.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Ft.instancing===!1||!Z.isInstancedMesh&&Ft.instancing===!0||Z.isSkinnedMesh&&Ft.skinning===!1||!Z.isSkinnedMesh&&Ft.skinning===!0||Z.isInstancedMesh&&Ft.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Ft.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Ft.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Ft.instancingMorph===!1&&Z.morphTexture!==null||Ft.envMap!==kt||$.fog===!0&&Ft.fog!==Tt||Ft.numClippingPlanes!==void 0&&(Ft.numClippingPlanes!==it.numPlanes||Ft.numIntersection!==it.numIntersection)||Ft.vertexAlphas!==te||Ft.vertexTangents!==pe||Ft.morphTargets!==Bt||Ft.morphNormals!==me||Ft.morphColors!==nn||Ft.morphTargetsCount!==Mn||Ft.numLightProbeGrids!==hn(A.state.lightProbeGridArray)?_e=!0:(Ft.outputColorSpace!==Et||Ft.toneMapping!==Ne)&&(vs=!0):(_e=!0,Ft.__version=$.version);let _n=Ft.currentProgram;(_e===!0||vs===!0)&&(_n=vs===!0?mi($,z,Z,Et,Ne):ns($,z,Z),V&&$.isNodeMaterial&&V.onUpdateProgram($,_n,Ft));let qr=!1,is=!1,bs=!1,ue=_n.getUniforms(),on=Ft.uniforms;if(Mt.useProgram(_n.program)&&(qr=!0,is=!0,bs=!0),$.id!==j&&(j=$.id,is=!0),qr||Q!==E){Mt.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),ue.setValue(k,"projectionMatrix",E.projectionMatrix),ue.setValue(k,"viewMatrix",E.matrixWorldInverse);let xn=ue.map.cameraPosition;xn!==void 0&&xn.setValue(k,Ln.setFromMatrixPosition(E.matrixWorld)),ae.logarithmicDepthBuffer&&ue.setValue(k,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&ue.setValue(k,"isOrthographic",E.isOrthographicCamera===!0),Q!==E&&(Q=E,is=!0,bs=!0)}if(Ft.needsLights&&(gn.state.sunShadowMap.length>0&&ue.setValue(k,"sunShadowMap",gn.state.sunShadowMap,qt),gn.state.directionalShadowMap.length>0&&ue.setValue(k,"directionalShadowMap",gn.state.directionalShadowMap,qt),gn.state.spotShadowMap.length>0&&ue.setValue(k,"spotShadowMap",gn.state.spotShadowMap,qt),gn.state.pointShadowMap.length>0&&ue.setValue(k,"pointShadowMap",gn.state.pointShadowMap,qt)),Z.isSkinnedMesh){ue.setOptional(k,Z,"bindMatrix"),ue.setOptional(k,Z,"bindMatrixInverse");let Ue=Z.skeleton;Ue&&(Ue.boneTexture===null&&Ue.computeBoneTexture(),ue.setValue(k,"boneTexture",Ue.boneTexture,qt))}Z.isBatchedMesh&&(ue.setOptional(k,Z,"batchingTexture"),ue.setValue(k,"batchingTexture",Z._matricesTexture,qt),ue.setOptional(k,Z,"batchingIdTexture"),ue.setValue(k,"batchingIdTexture",Z._indirectTexture,qt),ue.setOptional(k,Z,"batchingColorTexture"),Z._colorsTexture!==null&&ue.setValue(k,"batchingColorTexture",Z._colorsTexture,qt));let Jn=J.morphAttributes;if((Jn.position!==void 0||Jn.normal!==void 0||Jn.color!==void 0)&&rt.update(Z,J,_n),(is||Ft.receiveShadow!==Z.receiveShadow)&&(Ft.receiveShadow=Z.receiveShadow,ue.setValue(k,"receiveShadow",Z.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&z.environment!==null&&(on.envMapIntensity.value=z.environmentIntensity),on.dfgLUT!==void 0&&(on.dfgLUT.value=QM()),is){if(ue.setValue(k,"toneMappingExposure",F.toneMappingExposure),Ft.needsLights&&Wr(on,bs),Tt&&$.fog===!0&&_t.refreshFogUniforms(on,Tt),_t.refreshMaterialUniforms(on,$,St,At,A.state.transmissionRenderTarget[E.id]),Ft.needsLights&&Ft.numLightProbeGrids>0){let Ue=b,xn=0;for(let $n of A.state.lightProbeGridArray)$n.texture!==null&&(Ue.textures[xn]=$n.texture,Ue.min[xn]=$n.boundingBox.min,Ue.max[xn]=$n.boundingBox.max,Ue.resolution[xn]=$n.resolution,xn++);for(let $n in Ue)Ue[$n].length=xn;on.probesSH.value=Ue.textures,on.probesMin.value=Ue.min,on.probesMax.value=Ue.max,on.probesResolution.value=Ue.resolution}Uo.upload(k,Ws(Ft),on,qt)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(Uo.upload(k,Ws(Ft),on,qt),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&ue.setValue(k,"center",Z.center),ue.setValue(k,"modelViewMatrix",Z.modelViewMatrix),ue.setValue(k,"normalMatrix",Z.normalMatrix),ue.setValue(k,"modelMatrix",Z.matrixWorld),$.uniformsGroups!==void 0){let Ue=$.uniformsGroups;for(let xn=0,$n=Ue.length;xn<$n;xn++){let yl=Ue[xn];Gt.update(yl,_n),Gt.bind(yl,_n)}}return _n}function Wr(E,z){E.ambientLightColor.needsUpdate=z,E.lightProbe.needsUpdate=z,E.sunLights.needsUpdate=z,E.sunLightShadows.needsUpdate=z,E.directionalLights.needsUpdate=z,E.directionalLightShadows.needsUpdate=z,E.pointLights.needsUpdate=z,E.pointLightShadows.needsUpdate=z,E.spotLights.needsUpdate=z,E.spotLightShadows.needsUpdate=z,E.rectAreaLights.needsUpdate=z,E.hemisphereLights.needsUpdate=z}function Xs(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return W},this.getRenderTarget=function(){return ct},this.setRenderTargetTextures=function(E,z,J){let $=zt.get(E);$.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),zt.get(E.texture).__webglTexture=z,zt.get(E.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:J,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,z){let J=zt.get(E);J.__webglFramebuffer=z,J.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(E,z=0,J=0){ct=E,Y=z,W=J;let $=null,Z=!1,Tt=!1;if(E){let Et=zt.get(E);if(Et.__useDefaultFramebuffer!==void 0){Mt.bindFramebuffer(k.FRAMEBUFFER,Et.__webglFramebuffer),st.copy(E.viewport),dt.copy(E.scissor),ut=E.scissorTest,Mt.viewport(st),Mt.scissor(dt),Mt.setScissorTest(ut),j=-1;return}else if(Et.__webglFramebuffer===void 0)qt.setupRenderTarget(E);else if(Et.__hasExternalTextures)qt.rebindTextures(E,zt.get(E.texture).__webglTexture,zt.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let te=E.depthTexture;if(Et.__boundDepthTexture!==te){if(te!==null&&zt.has(te)&&(E.width!==te.image.width||E.height!==te.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");qt.setupDepthRenderbuffer(E)}}let It=E.texture;(It.isData3DTexture||It.isDataArrayTexture||It.isCompressedArrayTexture)&&(Tt=!0);let kt=zt.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(kt[z])?$=kt[z][J]:$=kt[z],Z=!0):E.samples>0&&qt.useMultisampledRTT(E)===!1?$=zt.get(E).__webglMultisampledFramebuffer:Array.isArray(kt)?$=kt[J]:$=kt,st.copy(E.viewport),dt.copy(E.scissor),ut=E.scissorTest}else st.copy(Vt).multiplyScalar(St).floor(),dt.copy(fe).multiplyScalar(St).floor(),ut=he;if(J!==0&&($=H),Mt.bindFramebuffer(k.FRAMEBUFFER,$)&&Mt.drawBuffers(E,$),Mt.viewport(st),Mt.scissor(dt),Mt.setScissorTest(ut),Z){let Et=zt.get(E.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+z,Et.__webglTexture,J)}else if(Tt){let Et=z;for(let It=0;It<E.textures.length;It++){let kt=zt.get(E.textures[It]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+It,kt.__webglTexture,J,Et)}}else if(E!==null&&J!==0){let Et=zt.get(E.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Et.__webglTexture,J)}j=-1};function Xr(E){let z=zt.get(E);return(z.__readFormat!==E.format||z.__readType!==E.type)&&(z.__readFormat=E.format,z.__readType=E.type,z.__formatReadable=ae.textureFormatReadable(E.format),z.__typeReadable=ae.textureTypeReadable(E.type)),z}this.readRenderTargetPixels=function(E,z,J,$,Z,Tt,Lt,Et=0){if(!(E&&E.isWebGLRenderTarget)){ee("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let It=zt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Lt!==void 0&&(It=It[Lt],Array.isArray(It)&&(It=It[0])),It){Mt.bindFramebuffer(k.FRAMEBUFFER,It);try{let kt=E.textures[Et],te=kt.format,pe=kt.type;E.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Et);let Bt=Xr(kt);if(Bt.__formatReadable===!1){ee("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Bt.__typeReadable===!1){ee("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=E.width-$&&J>=0&&J<=E.height-Z&&k.readPixels(z,J,$,Z,gt.convert(te),gt.convert(pe),Tt)}finally{let kt=ct!==null?zt.get(ct).__webglFramebuffer:null;Mt.bindFramebuffer(k.FRAMEBUFFER,kt)}}},this.readRenderTargetPixelsAsync=async function(E,z,J,$,Z,Tt,Lt,Et=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let It=zt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Lt!==void 0&&(It=It[Lt],Array.isArray(It)&&(It=It[0])),It)if(z>=0&&z<=E.width-$&&J>=0&&J<=E.height-Z){Mt.bindFramebuffer(k.FRAMEBUFFER,It);let kt=E.textures[Et],te=kt.format,pe=kt.type;E.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Et);let Bt=Xr(kt);if(Bt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Bt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let me=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,me),k.bufferData(k.PIXEL_PACK_BUFFER,Tt.byteLength,k.STREAM_READ),k.readPixels(z,J,$,Z,gt.convert(te),gt.convert(pe),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let nn=ct!==null?zt.get(ct).__webglFramebuffer:null;Mt.bindFramebuffer(k.FRAMEBUFFER,nn);let Ne=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await Wm(k,Ne,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,me),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,Tt),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(me),k.deleteSync(Ne),Tt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,z=null,J=0){let $=Math.pow(2,-J),Z=Math.floor(E.image.width*$),Tt=Math.floor(E.image.height*$),Lt=z!==null?z.x:0,Et=z!==null?z.y:0;qt.setTexture2D(E,0),k.copyTexSubImage2D(k.TEXTURE_2D,J,0,0,Lt,Et,Z,Tt),Mt.unbindTexture()},this.copyTextureToTexture=function(E,z,J=null,$=null,Z=0,Tt=0){let Lt,Et,It,kt,te,pe,Bt,me,nn,Ne=E.isCompressedTexture?E.mipmaps[Tt]:E.image;if(J!==null)Lt=J.max.x-J.min.x,Et=J.max.y-J.min.y,It=J.isBox3?J.max.z-J.min.z:1,kt=J.min.x,te=J.min.y,pe=J.isBox3?J.min.z:0;else{let ue=Math.pow(2,-Z);Lt=Math.floor(Ne.width*ue),Et=Math.floor(Ne.height*ue),E.isDataArrayTexture?It=Ne.depth:E.isData3DTexture?It=Math.floor(Ne.depth*ue):It=1,kt=0,te=0,pe=0}$!==null?(Bt=$.x,me=$.y,nn=$.z):(Bt=0,me=0,nn=0);let Fe=gt.convert(z.format),Mn=gt.convert(z.type),Ft;z.isData3DTexture?(qt.setTexture3D(z,0),Ft=k.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(qt.setTexture2DArray(z,0),Ft=k.TEXTURE_2D_ARRAY):(qt.setTexture2D(z,0),Ft=k.TEXTURE_2D),Mt.activeTexture(k.TEXTURE0),Mt.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,z.flipY),Mt.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),Mt.pixelStorei(k.UNPACK_ALIGNMENT,z.unpackAlignment);let gn=Mt.getParameter(k.UNPACK_ROW_LENGTH),_e=Mt.getParameter(k.UNPACK_IMAGE_HEIGHT),vs=Mt.getParameter(k.UNPACK_SKIP_PIXELS),_n=Mt.getParameter(k.UNPACK_SKIP_ROWS),qr=Mt.getParameter(k.UNPACK_SKIP_IMAGES);Mt.pixelStorei(k.UNPACK_ROW_LENGTH,Ne.width),Mt.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Ne.height),Mt.pixelStorei(k.UNPACK_SKIP_PIXELS,kt),Mt.pixelStorei(k.UNPACK_SKIP_ROWS,te),Mt.pixelStorei(k.UNPACK_SKIP_IMAGES,pe);let is=E.isDataArrayTexture||E.isData3DTexture,bs=z.isDataArrayTexture||z.isData3DTexture;if(E.isDepthTexture){let ue=zt.get(E),on=zt.get(z),Jn=zt.get(ue.__renderTarget),Ue=zt.get(on.__renderTarget);Mt.bindFramebuffer(k.READ_FRAMEBUFFER,Jn.__webglFramebuffer),Mt.bindFramebuffer(k.DRAW_FRAMEBUFFER,Ue.__webglFramebuffer);for(let xn=0;xn<It;xn++)is&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,zt.get(E).__webglTexture,Z,pe+xn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,zt.get(z).__webglTexture,Tt,nn+xn)),k.blitFramebuffer(kt,te,kt+Lt,te+Et,Bt,me,Bt+Lt,me+Et,k.DEPTH_BUFFER_BIT,k.NEAREST);Mt.bindFramebuffer(k.READ_FRAMEBUFFER,null),Mt.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(Z!==0||E.isRenderTargetTexture||zt.has(E)){let ue=zt.get(E),on=zt.get(z);Mt.bindFramebuffer(k.READ_FRAMEBUFFER,N),Mt.bindFramebuffer(k.DRAW_FRAMEBUFFER,X);for(let Jn=0;Jn<It;Jn++)is?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,ue.__webglTexture,Z,pe+Jn):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,ue.__webglTexture,Z),bs?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,on.__webglTexture,Tt,nn+Jn):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,on.__webglTexture,Tt),Z!==0?k.blitFramebuffer(kt,te,kt+Lt,te+Et,Bt,me,Bt+Lt,me+Et,k.COLOR_BUFFER_BIT,k.NEAREST):bs?k.copyTexSubImage3D(Ft,Tt,Bt,me,nn+Jn,kt,te,Lt,Et):k.copyTexSubImage2D(Ft,Tt,Bt,me,kt,te,Lt,Et);Mt.bindFramebuffer(k.READ_FRAMEBUFFER,null),Mt.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else bs?E.isDataTexture||E.isData3DTexture?k.texSubImage3D(Ft,Tt,Bt,me,nn,Lt,Et,It,Fe,Mn,Ne.data):z.isCompressedArrayTexture?k.compressedTexSubImage3D(Ft,Tt,Bt,me,nn,Lt,Et,It,Fe,Ne.data):k.texSubImage3D(Ft,Tt,Bt,me,nn,Lt,Et,It,Fe,Mn,Ne):E.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,Tt,Bt,me,Lt,Et,Fe,Mn,Ne.data):E.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,Tt,Bt,me,Ne.width,Ne.height,Fe,Ne.data):k.texSubImage2D(k.TEXTURE_2D,Tt,Bt,me,Lt,Et,Fe,Mn,Ne);Mt.pixelStorei(k.UNPACK_ROW_LENGTH,gn),Mt.pixelStorei(k.UNPACK_IMAGE_HEIGHT,_e),Mt.pixelStorei(k.UNPACK_SKIP_PIXELS,vs),Mt.pixelStorei(k.UNPACK_SKIP_ROWS,_n),Mt.pixelStorei(k.UNPACK_SKIP_IMAGES,qr),Tt===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&k.generateMipmap(Ft),Mt.unbindTexture()},this.initRenderTarget=function(E){zt.get(E).__webglFramebuffer===void 0&&qt.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?qt.setTextureCube(E,0):E.isData3DTexture?qt.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?qt.setTexture2DArray(E,0):qt.setTexture2D(E,0),Mt.unbindTexture()},this.resetState=function(){Y=0,W=0,ct=null,Mt.reset(),bt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ni}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=ye._getDrawingBufferColorSpace(t),e.unpackColorSpace=ye._getUnpackColorSpace()}};var Dh=class{system=matchMedia("(prefers-color-scheme: dark)");listeners=[];chosen=null;constructor(){this.system.addEventListener("change",()=>this.changed()),this.apply()}get theme(){return this.chosen??(this.system.matches?"dark":"light")}toggle(){this.chosen=this.theme==="dark"?"light":"dark",this.changed()}onChange(t){this.listeners.push(t)}apply(){document.documentElement.dataset.theme=this.theme}changed(){this.apply();for(let t of this.listeners)t()}},ce=i=>getComputedStyle(document.body).getPropertyValue(i).trim();var An={finding:{label:"finding",colour:"--mark-finding",shape:0,sizePx:15},rewind:{label:"rewind",colour:"--mark-rewind",shape:1,sizePx:12},pole:{label:"near the pole",colour:"--mark-pole",shape:2,sizePx:9},retract:{label:"retract",colour:"--mark-retract",shape:3,sizePx:11},inserted:{label:"inserted point",colour:"--mark-inserted",shape:4,sizePx:4}},Ag=Object.keys(An),tw=4e3,ew=3e3,nw=`
  uniform float size;
  void main() {
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    gl_Position.z -= 0.0005;
    gl_PointSize = size;
  }
`,iw=`
  uniform vec3 colour;
  uniform vec3 edge;
  uniform int shape;
  out vec4 fragment;
  // Distance from the outline, in halves of the point's size; negative inside.
  float outline(vec2 p) {
    if (shape == 0) return max(abs(p.x) * 0.87 + p.y * 0.5, -p.y) - 0.45;
    if (shape == 1) return abs(p.x) + abs(p.y) - 0.9;
    if (shape == 2) return max(abs(p.x), abs(p.y)) - 0.75;
    if (shape == 3) return max(abs(p.x) * 0.87 - p.y * 0.5, p.y) - 0.45;
    return length(p) - 0.85;
  }
  void main() {
    vec2 p = vec2(gl_PointCoord.x * 2.0 - 1.0, 1.0 - gl_PointCoord.y * 2.0);
    float d = outline(p);
    if (d > 0.0) discard;
    fragment = linearToOutputTexel(vec4(shape != 4 && d > -0.17 ? edge : colour, 1.0));
  }
`;function df(i,t){if(t==="finding")return i.head.findings.flatMap(n=>n.point===null?[]:[n.point]);let e=[];for(let n of i.stretches)if(n.kind===t)if(t==="inserted")for(let s=n.first;s<=n.last;s+=1)e.push(s);else e.push(n.first,...n.last>n.first?[n.last]:[]);return e}var Nh=class i{constructor(t,e,n,s){this.kind=e;let r=Math.ceil(n.length/tw);this.points=n.filter((u,d)=>d%r===0);let o=new Float32Array(this.points.flatMap(u=>t.tipAt(u))),a=new Ee;a.setAttribute("position",new we(o,3));let{shape:l,sizePx:c}=An[e],h=new kn({glslVersion:zs,vertexShader:nw,fragmentShader:iw,uniforms:{colour:{value:new Zt},edge:{value:new Zt},shape:{value:l},size:{value:c*s}}});this.object=new Mr(a,h),this.object.name=`marks ${e}`,this.object.frustumCulled=!1,this.object.renderOrder=e==="finding"?3:2}kind;object;points;static of(t,e,n){let s=df(t,e);return s.length===0?null:new i(t,e,s,n)}show(t,e){let n=this.points.findIndex(r=>r>=t),s=this.points.filter(r=>r>=t&&r<=e).length;this.object.geometry.setDrawRange(n<0?0:n,s)}restyle(){this.object.material.uniforms.colour.value.set(ce(An[this.kind].colour)),this.object.material.uniforms.edge.value.set(ce("--viewport"))}},Fh=class{object;every;points=[];constructor(t,e){this.every=Math.max(1,Math.ceil(t.count/ew));let n=[];for(let r=0;r<t.count;r+=this.every){let o=t.tipAt(r);t.isRapid(r)||t.isStart(r)||!Number.isFinite(o[0])||(this.points.push(r),n.push(...o,...o.map((a,l)=>a+e*t.toolAxis[l][r])))}let s=new Ee;s.setAttribute("position",new we(new Float32Array(n),3)),this.object=new Ti(s,new ui({transparent:!0,opacity:.55})),this.object.name="tool axis ticks",this.object.frustumCulled=!1}show(t,e){let n=this.points.findIndex(r=>r>=t),s=this.points.filter(r=>r>=t&&r<=e).length;this.object.geometry.setDrawRange(n<0?0:2*n,2*s)}restyle(){this.object.material.color.set(ce("--tick"))}};var ff=200,Uh=class{constructor(t,e){this.program=t;this.events=e;let{findings:n,warnings:s}=t.head;this.root.append(L("h2",{},n.length===0?"Findings":`Findings (${n.length})`)),n.length===0?this.root.append(L("p",{class:"good"},"The check found nothing: the program agrees with its CL data, for the machine of the tab Machine.")):this.root.append(L("ol",{class:"entries"},...n.map((r,o)=>L("li",{},this.finding(o))))),s.length>0&&this.root.append(L("h2",{},`Warnings (${s.length})`),L("ul",{class:"warnings"},...s.map(r=>L("li",{},r))));for(let r of["rewind","retract","pole"])this.addMarks(r)}program;events;root=L("section",{class:"panel",id:"findings","aria-label":"Findings and marks"});step(t,e){let n=this.program.head.findings.map(o=>o.line).sort((o,a)=>o-a),r=(t===1?n.find(o=>o>e):n.findLast(o=>o<e))??(t===1?n[0]:n.at(-1));r!==void 0&&this.events.showLine(r)}finding(t){let e=this.program.head.findings[t],n=e.last_line>e.line?`lines ${e.line} to ${e.last_line}`:`line ${e.line}`,s=L("button",{type:"button",class:"entry"},L("span",{class:"place"},L("span",{class:"mark mark-finding"}),`${n}, CL line ${e.cl_line}`),L("span",{class:"text"},e.text));return e.help!==null&&s.append(L("span",{class:"help"},e.help)),s.addEventListener("click",()=>this.events.showLine(e.line)),s}addMarks(t){let e=this.program.stretches.filter(o=>o.kind===t);if(e.length===0)return;let{label:n}=An[t],s=e.slice(0,ff).map(o=>{let a=this.program.line[o.first],l=this.program.line[o.last],c=L("button",{type:"button",class:"entry one-line"},L("span",{class:`mark mark-${t}`}),a===l?`line ${a}`:`lines ${a} to ${l}`,L("span",{class:"when"},ni(this.program.countedS[o.first])));return c.addEventListener("click",()=>this.events.seek(o.first)),L("li",{},c)}),r=e.length>ff?L("p",{class:"note"},`and ${e.length-ff} more`):"";this.root.append(L("details",{},L("summary",{},`${n.charAt(0).toUpperCase()}${n.slice(1)} (${e.length})`),L("ol",{class:"entries"},...s),r))}},Oh=class{constructor(t,e,n){this.program=t;this.events=e;this.root.append(L("h2",{},"Operations"),this.list),this.restyle(n)}program;events;root=L("section",{class:"panel","aria-label":"Operations"});list=L("ol",{class:"entries"});current=-1;restyle(t){ii(this.list,...this.program.head.operations.map((e,n)=>L("li",{},this.operation(n,t)))),this.mark()}update(t){let e=this.program.operation[t];e!==this.current&&(this.current=e,this.mark())}mark(){[...this.list.children].forEach((t,e)=>{let n=t.firstElementChild;e===this.current?n?.setAttribute("aria-current","true"):n?.removeAttribute("aria-current")})}operation(t,e){let{operations:n,set_ups:s}=this.program.head,r=n[t],o=L("span",{class:"sample"});o.style.setProperty("--sample",Vn(Ms(t,e)));let a=[`T${r.tool}`,r.mode,s.length>1?s[r.set_up]?.name??"":"",ni(r.seconds)],l=L("button",{type:"button",class:"entry"},L("span",{class:"place"},o,`${r.number}. ${r.name}`),L("span",{class:"help"},a.filter(c=>c!=="").join(" \xB7 ")));return l.disabled=r.points===0,l.addEventListener("click",()=>this.events.seek(r.first_point)),l}};function Cg(i,t){let e=i.joints[t].sign;return t<i.frame_after?e===1?-1:1:e}function nl(i,t){return Qt(i.joints[t].direction,Cg(i,t))}function Rg(i){return new pf(i).build()}var pf=class{constructor(t){this.input=t;let{machine:e,box:n,gaugeMm:s}=t;this.up=no(e.tool_axis),this.back=io(this.up,[0,1,0]),this.far=io(this.up,[-.3,1,0]);let r=tn(n.max,n.min);this.partCentre=Qt(Me(n.min,n.max),.5),this.partRadius=Math.max(wn(r)/2,1),this.unitMm=Math.max(20,.55*wn(r),.45*s)}input;bodies=[];arrows=[];up;back;far;unitMm;partCentre;partRadius;build(){let{machine:t}=this.input,e=Math.min(...this.corners().map(o=>un(o,this.up))),n=un(this.partCentre,this.up)-e+.1*this.unitMm,s={side:"table",anchor:tn(this.partCentre,Qt(this.up,n)),centre:this.partCentre,reachMm:this.partRadius,outward:Qt(this.up,-1)};for(let o=0;o<t.frame_after;o+=1)this.stack(s,o,o,o+1);let r=this.spindle();for(let o=t.joints.length-1;o>=t.frame_after;o-=1)this.stack(r,o,o+1,o);return this.bed(s,r),{bodies:this.bodies,arrows:this.arrows,unitMm:this.unitMm}}corners(){let{min:t,max:e}=this.input.box,n=[];for(let s of[t[0],e[0]])for(let r of[t[1],e[1]])for(let o of[t[2],e[2]])n.push([s,r,o]);return n}spindle(){let{machine:t,gaugeMm:e}=this.input,n=this.unitMm,s=t.joints.length,r=Qt(this.up,e),o=t.frame_after===s?"bed":"head";this.body(s,o,"body",this.cylinder(Me(r,Qt(this.up,.06*n)),this.up,.2*n,.12*n)),this.body(s,o,"body",this.cylinder(Me(r,Qt(this.up,.42*n)),this.up,.26*n,.6*n));let a=Me(r,Qt(this.up,.42*n));return{side:"head",anchor:a,centre:a,reachMm:.36*n,outward:this.up}}stack(t,e,n,s){this.input.machine.joints[e].rotary?this.rotary(t,e,n,s):this.slide(t,e,n,s)}rotary(t,e,n,s){let r=this.input.machine.joints[e],o=this.unitMm,a=r.direction,l=this.input.points[e],c=w=>Me(l,Qt(a,un(tn(w,l),a))),h=Math.abs(un(a,t.outward))>.9,u=h?t.outward:Me(this.far,Qt(t.outward,.6)),d=un(a,u)>=0?a:Qt(a,-1),f=.42*o,m;if(h&&t.side==="table"){let w=this.corners().map(U=>wn(oa(tn(U,l),a)));f=Math.min(Math.max(.6*o,Math.max(...w)*1.12),2.5*o),m=c(t.anchor)}else h?m=c(Me(t.centre,Qt(d,t.reachMm))):m=Me(c(t.centre),Qt(d,t.reachMm+.08*o));let v=.12*o,g=Me(m,Qt(d,v/2)),p=Me(m,Qt(d,v+.09*o)),y=t.side;this.body(n,y,"body",this.cylinder(g,a,f,v)),this.body(s,this.sideOf(s,y),"body",this.cylinder(p,a,f*.82,.18*o)),(wn(tn(g,t.anchor))>f||!h)&&this.elbow(n,y,t.anchor,g,d);let M=io(a,tn(Qt(this.up,h?0:.8),this.back)),b=(w,U)=>Me(Me(g,Qt(M,f*w)),Qt(d,U));this.body(n,y,"mark",{shape:"line",from:b(.35,-.51*v),to:b(1,-.51*v)}),this.body(s,this.sideOf(s,y),"mark",{shape:"line",from:b(1.02,0),to:b(1.22,0)});let C=Math.max(t.reachMm+.5*o,f*1.2),A=c(t.centre);this.body(s,this.sideOf(s,y),"centre-line",{shape:"line",from:tn(A,Qt(a,C)),to:Me(Me(p,Qt(d,.35*o)),Qt(a,0))}),this.arrows.push({joint:e,link:s,side:y,held:r.held,path:{kind:"arc",centre:g,axis:nl(this.input.machine,e),from:M,radius:f*1.14,sweepRad:.9}});let _=Me(p,Qt(d,.09*o));t.reachMm=h?Math.max(t.reachMm*.6,.3*o):Math.max(.5*o,Math.min(wn(tn(t.centre,_)),t.reachMm+.4*o)),t.centre=h?_:t.centre,t.anchor=_}slide(t,e,n,s){let r=this.input.machine.joints[e],o=this.unitMm,a=r.direction,l=Math.abs(un(a,t.outward))>.7,c=io(a,l?this.back:t.outward),h=ci(c,a),u=Cg(this.input.machine,e),d=l?t.side==="head"?.26*o:.1*o:t.side==="head"&&t.reachMm>.35*o?.3*o:0,f=Me(t.anchor,Qt(c,d+.09*o)),m=t.side;this.body(n,m,"carriage",this.box(f,a,h,[.7*o,.62*o,.18*o])),d>.12*o&&this.strut(n,m,t.anchor,f,.2*o,"carriage");let{min:v,max:g,low:p,high:y}=this.input.travel[e],[M,b]=[v??p,g??y],C=u*(M+b)/2,A=Math.max(b-M,0)+.7*o,_=d+.18*o;for(let U of[-.22*o,.22*o]){let F=Me(Me(t.anchor,Qt(c,_)),Me(Qt(h,U),Qt(a,C))),I=Qt(a,A/2);this.body(s,this.sideOf(s,m),"rail",{shape:"line",from:tn(F,I),to:Me(F,I)});for(let[V,H]of[[v,M],[g,b]]){if(V===null)continue;let N=H===b?.38*o:-.38*o,X=Me(F,Qt(a,u*(H+N)-C));this.body(s,this.sideOf(s,m),"stop",this.box(X,a,h,[.04*o,.1*o,.12*o]))}}this.arrows.push({joint:e,link:n,side:m,held:r.held,path:{kind:"straight",from:Me(f,Qt(nl(this.input.machine,e),.38*o)),direction:nl(this.input.machine,e),length:.5*o}});let w=l&&t.side==="head"?.42*o:.04*o;t.anchor=Me(t.anchor,Qt(c,_+w)),t.centre=t.anchor,t.reachMm=.35*o}bed(t,e){let{machine:n}=this.input,s=this.unitMm,r=n.frame_after,o=t.anchor;this.body(r,"bed","body",this.box(tn(o,Qt(this.up,.06*s)),this.back,ci(this.up,this.back),[.9*s,.9*s,.12*s]));let a=Math.max(un(o,this.back),un(e.anchor,this.back))+.9*s,l=Me(o,Qt(this.back,a-un(o,this.back))),c=Me(e.anchor,Qt(this.back,a-un(e.anchor,this.back))),h=Me(l,Qt(this.up,un(tn(c,l),this.up)));this.strut(r,"bed",tn(o,Qt(this.up,.06*s)),tn(l,Qt(this.up,.06*s)),.12*s),this.strut(r,"bed",l,h,.12*s),this.strut(r,"bed",h,c,.12*s),this.strut(r,"bed",c,e.anchor,.12*s)}elbow(t,e,n,s,r){let o=Me(n,Qt(r,un(tn(s,n),r)));this.strut(t,e,n,o,.11*this.unitMm),this.strut(t,e,o,s,.11*this.unitMm)}strut(t,e,n,s,r,o="body"){let a=tn(s,n),l=wn(a);if(l<.2*r)return;let c=Qt(a,1/l),h=io(c,this.up);this.body(t,e,o,this.box(Qt(Me(n,s),.5),c,h,[l+r,r,r]))}body(t,e,n,s){this.bodies.push({link:t,side:e,role:n,shape:s})}sideOf(t,e){return t===this.input.machine.frame_after?"bed":e}cylinder(t,e,n,s){return{shape:"cylinder",centre:t,axis:e,radius:n,height:s}}box(t,e,n,s){return{shape:"box",centre:t,along:e,across:n,size:s}}};var mf=["X","Y","Z"],il=1e-6;function Lg(i){let t=i.findIndex(e=>Math.abs(e)>1-il**2);return t<0||Math.hypot(...i.filter((e,n)=>n!==t))>il?null:{index:t,sign:i[t]>0?1:-1}}var Pg=i=>`(${i.map(t=>He(t,4)).join(", ")})`,sl=(i,t)=>t<i.frame_after?"table":"head";function Ig(i,t){let{letter:e,rotary:n}=i.joints[t],s=nl(i,t),r=sl(i,t),o=Lg(s);if(!n){let f=o?`${mf[o.index]}${o.sign>0?"+":"\u2212"}`:Pg(s);return`${e}+ moves the ${r} towards ${f}`}let a=f=>f?"anticlockwise":"clockwise";if(o){let f=o.index===2?"above (from Z+)":`${mf[o.index]}+`;return`${e}+ turns the ${r} ${a(o.sign>0)}, seen from ${f}`}let[l,c,h]=s,u=Math.abs(h)>il?h>0:Math.abs(c)>il?c>0:l>0,d=u?s:[-l,-c,-h];return`${e}+ turns the ${r} ${a(u)}, seen from the end ${Pg(d)} of its centre line`}function Dg(i,t){let e=Lg(i);return mf.flatMap((n,s)=>e?.index===s?[]:[`${n} ${He(t[s],3)}`]).join("  ")}function Ng(i,t){let e=tn(t.point,i.point),n=ci(i.direction,t.direction),s=wn(n);return s<il?wn(oa(e,i.direction)):Math.abs(un(e,n))/s}var Bh=class{constructor(t,e){this.program=t;this.undrawn=e;let{machine:n,control:s}=t.head;this.root.append(L("h2",{},"Machine"),L("dl",{class:"facts"},L("dt",{},"Name"),L("dd",{},n.name),L("dt",{},"Control"),L("dd",{},s)),L("p",{class:"compare"},"The check compares the program with the CL data for this machine. Compare every sign and every centre line with the real machine."),...this.gaps(),L("h2",{},"Axes from the workpiece to the tool"),L("ol",{class:"machine-axes"},...n.joints.map((r,o)=>L("li",{},this.axis(o)))),this.placementText)}program;undrawn;root=L("section",{class:"panel","aria-label":"Machine"});centreLines=[];placementText=L("p",{class:"note"});placement=-1;update(t){let e=this.program.placement[Math.floor(t)];if(e===this.placement)return;this.placement=e;let n=this.program.head.placements[e],{machine:s,set_ups:r}=this.program.head,o=s.joints.flatMap((c,h)=>c.rotary?[h]:[]),a=c=>({direction:s.joints[c].direction,point:n.points[c]});for(let{joint:c,node:h}of this.centreLines){let u=o[o.indexOf(c)+1],d=u===void 0||sl(s,c)!==sl(s,u)?"":`; ${He(Ng(a(c),a(u)),3)} mm from the centre line of ${s.joints[u].letter}`;ii(h,`${Dg(s.joints[c].direction,n.points[c])}${d}`)}let l=r[n.set_up];this.placementText.textContent=`Directions and centre lines with all axes at zero; centre lines in mm from the workpiece origin${l?` of ${l.name}`:""}, tool ${Sl(this.program.toolOfNumber(n.tool))}.`}gaps(){let{lines:t}=this.undrawn;return t.length===0?[]:[L("p",{class:"compare"},`${El(t)} ${aa}`)]}axis(t){let{program:e}=this,{machine:n}=e.head,s=n.joints[t],r=Gi(s),o=sl(n,t),a=[];if(s.held&&a.push(["Held",`at ${He(e.axes[t][0],3)} ${r}`]),s.rotary){let h=L("span");this.centreLines.push({joint:t,node:h}),a.push(["Centre line",h])}let l=s.min===null&&s.max===null?"none configured":`${Fg(s.min)} \u2026 ${Fg(s.max)} ${r}${s.rotary?"":", machine coordinates"}`;a.push(["Limits",l],["Speed",s.speed===null?"none configured":`${xe(s.speed)} ${r}/min`]);let c=L("dl",{class:"facts"});for(let[h,u]of a)c.append(L("dt",{},h),L("dd",{},u));return L("div",{class:`machine-axis ${o}${s.held?" held":""}`},L("p",{class:"axis-title"},L("strong",{},s.letter),` ${s.rotary?"rotary":"linear"}, ${o} side${s.held?", held":""}`),L("p",{class:"axis-motion"},Ig(n,t)),c)}},Fg=i=>i===null?"unlimited":xe(i);var sw="uplot",rw="u-hz",ow="u-vt",aw="u-title",lw="u-wrap",cw="u-under",hw="u-over",uw="u-axis",Dr="u-off",dw="u-select",fw="u-cursor-x",pw="u-cursor-y",mw="u-cursor-pt",gw="u-legend",_w="u-live",xw="u-inline",yw="u-series",vw="u-marker",Ug="u-label",bw="u-value",ol="width",al="height";var Og="bottom",Bo="left",gf="right",Df="#000",Bg=Df+"0",_f="mousemove",kg="mousedown",xf="mouseup",zg="mouseenter",Vg="mouseleave",Gg="dblclick",Sw="resize",Mw="scroll",Hg="change",Hh="dppxchange",Nf="--",Xo=typeof window<"u",Mf=Xo?document:null,zo=Xo?window:null,ww=Xo?navigator:null,Re,kh;function wf(){let i=devicePixelRatio;Re!=i&&(Re=i,kh&&Ef(Hg,kh,wf),kh=matchMedia(`(min-resolution: ${Re-.001}dppx) and (max-resolution: ${Re+.001}dppx)`),Nr(Hg,kh,wf),zo.dispatchEvent(new CustomEvent(Hh)))}function Ci(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function Tf(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function je(i,t,e){i.style[t]=e+"px"}function Ji(i,t,e,n){let s=Mf.createElement(i);return t!=null&&Ci(s,t),e?.insertBefore(s,n),s}function Oi(i,t){return Ji("div",i,t)}var Wg=new WeakMap;function ps(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=Wg.get(i);r!=o&&(i.style.transform=r,Wg.set(i,r),t<0||e<0||t>n||e>s?Ci(i,Dr):Tf(i,Dr))}var Xg=new WeakMap;function qg(i,t,e){let n=t+e,s=Xg.get(i);n!=s&&(Xg.set(i,n),i.style.background=t,i.style.borderColor=e)}var $g=new WeakMap;function Yg(i,t,e,n){let s=t+""+e,r=$g.get(i);s!=r&&($g.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var Ff={passive:!0},Tw={...Ff,capture:!0};function Nr(i,t,e,n){t.addEventListener(i,e,n?Tw:Ff)}function Ef(i,t,e,n){t.removeEventListener(i,e,Ff)}Xo&&wf();function Qi(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:Ri((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function S0(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var M0=i=>i!=null,w0=i=>i!=null&&i>0,qh=S0(M0),Ew=S0(w0);function Aw(i,t,e,n=0,s=!1){let r=s?Ew:qh,o=s?w0:M0;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??ze,l??-ze]}function $h(i,t,e,n){let s=jg(i),r=jg(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?Vs:T0,a=s==1?Ri:Bi,l=r==1?Bi:Ri,c=a(o(Rn(i))),h=l(o(Rn(t))),u=Vo(e,c),d=Vo(e,h);return e==10&&(c<0&&(u=Ve(u,-c)),h<0&&(d=Ve(d,-h))),n||e==2?(i=u*s,t=d*r):(i=R0(i,u),t=Yh(t,d)),[i,t]}function Uf(i,t,e,n){let s=$h(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var Of=.1,Zg={mode:3,pad:Of},cl={pad:0,soft:null,mode:0},Cw={min:cl,max:cl};function Wh(i,t,e,n){return Zh(e)?Kg(i,t,e):(cl.pad=e,cl.soft=n?0:null,cl.mode=n?3:0,Kg(i,t,Cw))}function Ae(i,t){return i??t}function Rw(i,t,e){for(t=Ae(t,0),e=Ae(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function Kg(i,t,e){let n=e.min,s=e.max,r=Ae(n.pad,0),o=Ae(s.pad,0),a=Ae(n.hard,-ze),l=Ae(s.hard,ze),c=Ae(n.soft,ze),h=Ae(s.soft,-ze),u=Ae(n.mode,0),d=Ae(s.mode,0),f=t-i,m=Vs(f),v=li(Rn(i),Rn(t)),g=Vs(v),p=Rn(g-m);(f<1e-24||p>10)&&(f=0,(i==0||t==0)&&(f=1e-24,u==2&&c!=ze&&(r=0),d==2&&h!=-ze&&(o=0)));let y=f||v||1e3,M=Vs(y),b=Vo(10,Ri(M)),C=y*(f==0?i==0?.1:1:r),A=Ve(R0(i-C,b/10),24),_=i>=c&&(u==1||u==3&&A<=c||u==2&&A>=c)?c:ze,w=li(a,A<_&&i>=_?_:ts(_,A)),U=y*(f==0?t==0?.1:1:o),F=Ve(Yh(t+U,b/10),24),I=t<=h&&(d==1||d==3&&F>=h||d==2&&F<=h)?h:-ze,V=ts(l,F>I&&t<=I?I:li(I,F));return w==V&&w==0&&(V=100),[w,V]}var Pw=new Intl.NumberFormat(Xo?ww.language:"en-US"),Bf=i=>Pw.format(i),Pi=Math,Gh=Pi.PI,Rn=Pi.abs,Ri=Pi.floor,Cn=Pi.round,Bi=Pi.ceil,ts=Pi.min,li=Pi.max,Vo=Pi.pow,jg=Pi.sign,Vs=Pi.log10,T0=Pi.log2,Lw=(i,t=1)=>Pi.sinh(i)*t,yf=(i,t=1)=>Pi.asinh(i/t),ze=1/0;function Jg(i){return(Vs((i^i>>31)-(i>>31))|0)+1}function Af(i,t,e){return ts(li(i,t),e)}function E0(i){return typeof i=="function"}function ve(i){return E0(i)?i:()=>i}var Iw=()=>{},A0=i=>i,C0=(i,t)=>t,Dw=i=>null,Qg=i=>!0,t0=(i,t)=>i==t,Nw=/\.\d*?(?=9{6,}|0{6,})/gm,Fr=i=>{if(L0(i)||pr.has(i))return i;let t=`${i}`,e=t.match(Nw);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Fr(s)}e${r}`}return Ve(i,n)};function Lr(i,t){return Fr(Ve(Fr(i/t))*t)}function Yh(i,t){return Fr(Bi(Fr(i/t))*t)}function R0(i,t){return Fr(Ri(Fr(i/t))*t)}function Ve(i,t=0){if(L0(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return Cn(n)/e}var pr=new Map;function P0(i){return((""+i).split(".")[1]||"").length}function ul(i,t,e,n){let s=[],r=n.map(P0);for(let o=t;o<e;o++){let a=Rn(o),l=Ve(Vo(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=i==10?h:Ve(h,u);s.push(d),pr.set(d,u)}}return s}var hl={},kf=[],Go=[null,null],fr=Array.isArray,L0=Number.isInteger,Fw=i=>i===void 0;function e0(i){return typeof i=="string"}function Zh(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function Uw(i){return i!=null&&typeof i=="object"}var Ow=Object.getPrototypeOf(Uint8Array),I0="__proto__";function Ho(i,t=Zh){let e;if(fr(i)){let n=i.find(s=>s!=null);if(fr(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=Ho(i[s],t)}else e=i.slice()}else if(i instanceof Ow)e=i.slice();else if(t(i)){e={};for(let n in i)n!=I0&&(e[n]=Ho(i[n],t))}else e=i;return e}function bn(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=I0&&(Zh(i[s])?bn(i[s],Ho(n[s])):i[s]=Ho(n[s]))}return i}var Bw=0,kw=1,zw=2;function Vw(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function Gw(i,t){if(Xw(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return qw(o[0])||(o=Ww(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=t?t[o][c]:kw,f=[];for(let m=0;m<h.length;m++){let v=h[m],g=r.get(l[m]);v===null?d!=Bw&&(u[g]=v,d==zw&&f.push(g)):u[g]=v}Vw(u,f,s),n.push(u)}}return n}var Hw=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function Ww(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function Xw(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function qw(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=li(1,Ri((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var D0=["January","February","March","April","May","June","July","August","September","October","November","December"],N0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function F0(i){return i.slice(0,3)}var $w=N0.map(F0),Yw=D0.map(F0),Zw={MMMM:D0,MMM:Yw,WWWW:N0,WWW:$w};function rl(i){return(i<10?"0":"")+i}function Kw(i){return(i<10?"00":i<100?"0":"")+i}var jw={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>rl(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>rl(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>rl(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>rl(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>rl(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>Kw(i.getMilliseconds())};function zf(i,t){t=t||Zw;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?jw[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var Jw=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Qw(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==Jw?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var U0=i=>i%1==0,Xh=[1,2,2.5,5],t1=ul(10,-32,0,Xh),O0=ul(10,0,32,Xh),e1=O0.filter(U0),Ir=t1.concat(O0),Vf=`
`,B0="{YYYY}",n0=Vf+B0,k0="{M}/{D}",ll=Vf+k0,zh=ll+"/{YY}",z0="{aa}",n1="{h}:{mm}",ko=n1+z0,i0=Vf+ko,s0=":{ss}",De=null;function V0(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?ul(10,0,3,Xh).filter(U0):ul(10,-3,0,Xh)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,B0,De,De,De,De,De,De,1],[s*28,"{MMM}",n0,De,De,De,De,De,1],[s,k0,n0,De,De,De,De,De,1],[n,"{h}"+z0,zh,De,ll,De,De,De,1],[e,ko,zh,De,ll,De,De,De,1],[t,s0,zh+" "+ko,De,ll+" "+ko,De,i0,De,1],[i,s0+".{fff}",zh+" "+ko,De,ll+" "+ko,De,i0,De,1]];function h(u){return(d,f,m,v,g,p)=>{let y=[],M=g>=o,b=g>=r&&g<o,C=u(m),A=Ve(C*i,3),_=vf(C.getFullYear(),M?0:C.getMonth(),b||M?1:C.getDate()),w=Ve(_*i,3);if(b||M){let U=b?g/r:0,F=M?g/o:0,I=A==w?A:Ve(vf(_.getFullYear()+F,_.getMonth()+U,1)*i,3),V=new Date(Cn(I/i)),H=V.getFullYear(),N=V.getMonth();for(let X=0;I<=v;X++){let Y=vf(H+F*X,N+U*X,1),W=Y-u(Ve(Y*i,3));I=Ve((+Y+W)*i,3),I<=v&&y.push(I)}}else{let U=g>=s?s:g,F=Ri(m)-Ri(A),I=w+F+Yh(A-w,U);y.push(I);let V=u(I),H=V.getHours()+V.getMinutes()/e+V.getSeconds()/n,N=g/n,X=d.axes[f]._space,Y=p/X;for(;I=Ve(I+g,i==1?0:3),!(I>v);)if(N>1){let W=Ri(Ve(H+N,6))%24,Q=u(I).getHours()-W;Q>1&&(Q=-1),I-=Q*n,H=(H+N)%24;let st=y[y.length-1];Ve((I-st)/g,3)*Y>=.7&&y.push(I)}else y.push(I)}return y}}return[l,c,h]}var[i1,s1,r1]=V0(1),[o1,a1,l1]=V0(.001);ul(2,-53,53,[1]);function r0(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function o0(i,t){return(e,n,s,r,o)=>{let a=t.find(m=>o>=m[0])||t[t.length-1],l,c,h,u,d,f;return n.map(m=>{let v=i(m),g=v.getFullYear(),p=v.getMonth(),y=v.getDate(),M=v.getHours(),b=v.getMinutes(),C=v.getSeconds(),A=g!=l&&a[2]||p!=c&&a[3]||y!=h&&a[4]||M!=u&&a[5]||b!=d&&a[6]||C!=f&&a[7]||a[1];return l=g,c=p,h=y,u=M,d=b,f=C,A(v)})}}function c1(i,t){let e=zf(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function vf(i,t,e){return new Date(i,t,e)}function a0(i,t){return t(i)}var h1="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function l0(i,t){return(e,n,s,r)=>r==null?Nf:t(i(n))}function u1(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function d1(i,t){return i.series[t].fill(i,t)}var f1={show:!0,live:!0,isolate:!1,mount:Iw,markers:{show:!0,width:2,stroke:u1,fill:d1,dash:"solid"},idx:null,idxs:null,values:[]};function p1(i,t){let e=i.cursor.points,n=Oi(),s=e.size(i,t);je(n,ol,s),je(n,al,s);let r=s/-2;je(n,"marginLeft",r),je(n,"marginTop",r);let o=e.width(i,t,s);return o&&je(n,"borderWidth",o),n}function m1(i,t){let e=i.series[t].points;return e._fill||e._stroke}function g1(i,t){let e=i.series[t].points;return e._stroke||e._fill}function _1(i,t){return i.series[t].points.size}var bf=[0,0];function x1(i,t,e){return bf[0]=t,bf[1]=e,bf}function Vh(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function Sf(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var y1={show:!0,x:!0,y:!0,lock:!1,move:x1,points:{one:!1,show:p1,size:_1,width:0,stroke:g1,fill:m1},bind:{mousedown:Vh,mouseup:Vh,click:Vh,dblclick:Vh,mousemove:Sf,mouseleave:Sf,mouseenter:Sf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},G0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Gf=bn({},G0,{filter:C0}),H0=bn({},Gf,{size:10}),W0=bn({},G0,{show:!1}),Hf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',X0="bold "+Hf,q0=1.5,c0={show:!0,scale:"x",stroke:Df,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:X0,side:2,grid:Gf,ticks:H0,border:W0,font:Hf,lineGap:q0,rotate:0},v1="Value",b1="Time",h0={show:!0,scale:"x",auto:!1,sorted:1,min:ze,max:-ze,idxs:[]};function S1(i,t,e,n,s){return t.map(r=>r==null?"":Bf(r))}function M1(i,t,e,n,s,r,o){let a=[],l=pr.get(s)||0;e=o?e:Ve(Yh(e,s),l);for(let c=e;c<=n;c=Ve(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Cf(i,t,e,n,s,r,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?Vs:T0,h=Ri(c(e));s=Vo(l,h),l==10&&(s=Ir[Qi(s,Ir)]);let u=e,d=s*l;l==10&&(d=Ir[Qi(d,Ir)]);do a.push(u),u=u+s,l==10&&!pr.has(u)&&(u=Ve(u,pr.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=Ir[Qi(d,Ir)]));while(u<=n);return a}function w1(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?Cf(i,t,li(l,e),n,s):[l],h=n>=0&&e<=0?[0]:[];return(e<-l?Cf(i,t,li(l,-n),-e,s):[l]).reverse().map(d=>-d).concat(h,c)}var $0=/./,T1=/[12357]/,E1=/[125]/,u0=/1/,Rf=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function A1(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?$0:l(7,o)-h>=c?T1:l(5,o)-h>=c?E1:u0;if(u==u0){let d=Rn(l(1,o)-h);if(d<c)return Rf(t.slice().reverse(),a.distr,u,Bi(c/d)).reverse()}return Rf(t,a.distr,u,1)}function C1(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=Rn(l(1,o)-l(2,o));return c<a?Rf(t.slice().reverse(),3,$0,Bi(a/c)).reverse():t}function R1(i,t,e,n){return n==null?Nf:t==null?"":Bf(t)}var d0={show:!0,scale:"y",stroke:Df,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:X0,side:3,grid:Gf,ticks:H0,border:W0,font:Hf,lineGap:q0,rotate:0};function P1(i,t){let e=3+(i||1)*2;return Ve(e*t,3)}function L1(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=Rn(o-r),l=i.series[t],c=a/(l.points.space*Re);return n[1]-n[0]<=c}var f0={scale:null,auto:!0,sorted:0,min:ze,max:-ze},Y0=(i,t,e,n,s)=>s,p0={show:!0,auto:!0,sorted:0,gaps:Y0,alpha:1,facets:[bn({},f0,{scale:"x"}),bn({},f0,{scale:"y"})]},m0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Y0,alpha:1,points:{show:L1,filter:null},values:null,min:ze,max:-ze,idxs:[],path:null,clip:null};function I1(i,t,e,n,s){return e/10}var Z0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},D1=bn({},Z0,{time:!1,ori:1}),g0={};function K0(i,t){let e=g0[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(g0[i]=e)),e}var Wo=1,Pf=2;function Ur(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[t],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,m=a.width,v=a.height,g=i.valToPosH,p=i.valToPosV;return h.ori==0?e(s,l,c,h,u,g,p,d,f,m,v,jh,qo,Qh,J0,t_):e(s,l,c,h,u,p,g,f,d,v,m,Jh,$o,qf,Q0,e_)}function Wf(i,t){let e=0,n=0,s=Ae(i.bands,kf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function N1(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Gs(i,t,e,n,s,r){return Ur(i,t,(o,a,l,c,h,u,d,f,m,v,g)=>{let p=o.pxRound,y=c.dir*(c.ori==0?1:-1),M=c.ori==0?qo:$o,b,C;y==1?(b=e,C=n):(b=n,C=e);let A=p(u(a[b],c,v,f)),_=p(d(l[b],h,g,m)),w=p(u(a[C],c,v,f)),U=p(d(r==1?h.max:h.min,h,g,m)),F=new Path2D(s);return M(F,w,U),M(F,A,U),M(F,A,_),F})}function Kh(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?Qh:qf,l=e;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,n,f,n+r),l=d[1]}}let c=e+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function F1(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function Xf(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let f=r(i[u]),m=d==u?f:r(i[d]),v=u-s;f=o<=0&&v>=0&&v<l?r(i[v]):f;let p=d+s;m=o>=0&&p>=0&&p<l?r(i[p]):m,m>=f&&a.push([f,m])}return a}function _0(i){return i==0?A0:i==1?Cn:t=>Lr(t,i)}function j0(i){let t=i==0?jh:Jh,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=ts(c,a/2,l/2),h=ts(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var jh=(i,t,e)=>{i.moveTo(t,e)},Jh=(i,t,e)=>{i.moveTo(e,t)},qo=(i,t,e)=>{i.lineTo(t,e)},$o=(i,t,e)=>{i.lineTo(e,t)},Qh=j0(0),qf=j0(1),J0=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},Q0=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},t_=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},e_=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function n_(i){return(t,e,n,s,r)=>Ur(t,e,(o,a,l,c,h,u,d,f,m,v,g)=>{let{pxRound:p,points:y}=o,M,b;c.ori==0?(M=jh,b=J0):(M=Jh,b=Q0);let C=Ve(y.width*Re,3),A=(y.size-y.width)/2*Re,_=Ve(A*2,3),w=new Path2D,U=new Path2D,{left:F,top:I,width:V,height:H}=t.bbox;Qh(U,F-_,I-_,V+_*2,H+_*2);let N=X=>{if(l[X]!=null){let Y=p(u(a[X],c,v,f)),W=p(d(l[X],h,g,m));M(w,Y+A,W),b(w,Y,W,A,0,Gh*2)}};if(r)r.forEach(N);else for(let X=n;X<=s;X++)N(X);return{stroke:C>0?w:null,fill:w,clip:U,flags:Wo|Pf}})}function i_(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var U1=i_(qo),O1=i_($o);function s_(i){let t=Ae(i?.alignGaps,0);return(e,n,s,r)=>Ur(e,n,(o,a,l,c,h,u,d,f,m,v,g)=>{[s,r]=qh(l,s,r);let p=o.pxRound,y=H=>p(u(H,c,v,f)),M=H=>p(d(H,h,g,m)),b,C;c.ori==0?(b=qo,C=U1):(b=$o,C=O1);let A=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Wo},w=_.stroke,U=!1;if(r-s>=v*4){let H=ut=>e.posToVal(ut,c.key,!0),N=null,X=null,Y,W,ct,j=y(a[A==1?s:r]),Q=y(a[s]),st=y(a[r]),dt=H(A==1?Q+1:st-1);for(let ut=A==1?s:r;ut>=s&&ut<=r;ut+=A){let tt=a[ut],xt=(A==1?tt<dt:tt>dt)?j:y(tt),At=l[ut];xt==j?At!=null?(W=At,N==null?(b(w,xt,M(W)),Y=N=X=W):W<N?N=W:W>X&&(X=W)):At===null&&(U=!0):(N!=null&&C(w,j,M(N),M(X),M(Y),M(W)),At!=null?(W=At,b(w,xt,M(W)),N=X=Y=W):(N=X=null,At===null&&(U=!0)),j=xt,dt=H(j+A))}N!=null&&N!=X&&ct!=j&&C(w,j,M(N),M(X),M(Y),M(W))}else for(let H=A==1?s:r;H>=s&&H<=r;H+=A){let N=l[H];N===null?U=!0:N!=null&&b(w,y(a[H]),M(N))}let[I,V]=Wf(e,n);if(o.fill!=null||I!=0){let H=_.fill=new Path2D(w),N=o.fillTo(e,n,o.min,o.max,I),X=M(N),Y=y(a[s]),W=y(a[r]);A==-1&&([W,Y]=[Y,W]),b(H,W,X),b(H,Y,X)}if(!o.spanGaps){let H=[];U&&H.push(...Xf(a,l,s,r,A,y,t)),_.gaps=H=o.gaps(e,n,s,r,H),_.clip=Kh(H,c.ori,f,m,v,g)}return V!=0&&(_.band=V==2?[Gs(e,n,s,r,w,-1),Gs(e,n,s,r,w,1)]:Gs(e,n,s,r,w,V)),_})}function B1(i){let t=Ae(i.align,1),e=Ae(i.ascDesc,!1),n=Ae(i.alignGaps,0),s=Ae(i.extend,!1);return(r,o,a,l)=>Ur(r,o,(c,h,u,d,f,m,v,g,p,y,M)=>{[a,l]=qh(u,a,l);let b=c.pxRound,{left:C,width:A}=r.bbox,_=Q=>b(m(Q,d,y,g)),w=Q=>b(v(Q,f,M,p)),U=d.ori==0?qo:$o,F={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Wo},I=F.stroke,V=d.dir*(d.ori==0?1:-1),H=w(u[V==1?a:l]),N=_(h[V==1?a:l]),X=N,Y=N;s&&t==-1&&(Y=C,U(I,Y,H)),U(I,N,H);for(let Q=V==1?a:l;Q>=a&&Q<=l;Q+=V){let st=u[Q];if(st==null)continue;let dt=_(h[Q]),ut=w(st);t==1?U(I,dt,H):U(I,X,ut),U(I,dt,ut),H=ut,X=dt}let W=X;s&&t==1&&(W=C+A,U(I,W,H));let[ct,j]=Wf(r,o);if(c.fill!=null||ct!=0){let Q=F.fill=new Path2D(I),st=c.fillTo(r,o,c.min,c.max,ct),dt=w(st);U(Q,W,dt),U(Q,Y,dt)}if(!c.spanGaps){let Q=[];Q.push(...Xf(h,u,a,l,V,_,n));let st=c.width*Re/2,dt=e||t==1?st:-st,ut=e||t==-1?-st:st;Q.forEach(tt=>{tt[0]+=dt,tt[1]+=ut}),F.gaps=Q=c.gaps(r,o,a,l,Q),F.clip=Kh(Q,d.ori,g,p,y,M)}return j!=0&&(F.band=j==2?[Gs(r,o,a,l,I,-1),Gs(r,o,a,l,I,1)]:Gs(r,o,a,l,I,j)),F})}function x0(i,t,e,n,s,r,o=ze){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let h=Rn(i[l]-i[a]);h<c&&(c=h,o=Rn(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function k1(i){i=i||hl;let t=Ae(i.size,[.6,ze,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=ve(s),o=1-t[0],a=Ae(t[1],ze),l=Ae(t[2],1),c=Ae(i.disp,hl),h=Ae(i.each,f=>{}),{fill:u,stroke:d}=c;return(f,m,v,g)=>Ur(f,m,(p,y,M,b,C,A,_,w,U,F,I)=>{let V=p.pxRound,H=e,N=n*Re,X=a*Re,Y=l*Re,W,ct;b.ori==0?[W,ct]=r(f,m):[ct,W]=r(f,m);let j=b.dir*(b.ori==0?1:-1),Q=b.ori==0?Qh:qf,st=b.ori==0?h:(Rt,Yt,ae,Mt,ke,zt,qt)=>{h(Rt,Yt,ae,ke,Mt,qt,zt)},dt=Ae(f.bands,kf).find(Rt=>Rt.series[0]==m),ut=dt!=null?dt.dir:0,tt=p.fillTo(f,m,p.min,p.max,ut),mt=V(_(tt,C,I,U)),xt,At,St,Ht=F,oe=V(p.width*Re),Vt=!1,fe=null,he=null,ie=null,Je=null;u!=null&&(oe==0||d!=null)&&(Vt=!0,fe=u.values(f,m,v,g),he=new Map,new Set(fe).forEach(Rt=>{Rt!=null&&he.set(Rt,new Path2D)}),oe>0&&(ie=d.values(f,m,v,g),Je=new Map,new Set(ie).forEach(Rt=>{Rt!=null&&Je.set(Rt,new Path2D)})));let{x0:Ge,size:pn}=c;if(Ge!=null&&pn!=null){H=1,y=Ge.values(f,m,v,g),Ge.unit==2&&(y=y.map(ae=>f.posToVal(w+ae*F,b.key,!0)));let Rt=pn.values(f,m,v,g);pn.unit==2?At=Rt[0]*F:At=A(Rt[0],b,F,w)-A(0,b,F,w),Ht=x0(y,M,A,b,F,w,Ht),St=Ht-At+N}else Ht=x0(y,M,A,b,F,w,Ht),St=Ht*o+N,At=Ht-St;St<1&&(St=0),oe>=At/2&&(oe=0),St<5&&(V=A0);let Oe=St>0,Ln=Ht-St-(Oe?oe:0);At=V(Af(Ln,Y,X)),xt=(H==0?At/2:H==j?0:At)-H*j*((H==0?N/2:0)+(Oe?oe/2:0));let Se={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Sn=Vt?null:new Path2D,sn=null;if(dt!=null)sn=f.data[dt.series[1]];else{let{y0:Rt,y1:Yt}=c;Rt!=null&&Yt!=null&&(M=Yt.values(f,m,v,g),sn=Rt.values(f,m,v,g))}let mn=W*At,k=ct*At;for(let Rt=j==1?v:g;Rt>=v&&Rt<=g;Rt+=j){let Yt=M[Rt];if(Yt==null)continue;if(sn!=null){let q=sn[Rt]??0;if(Yt-q==0)continue;mt=_(q,C,I,U)}let ae=b.distr!=2||c!=null?y[Rt]:Rt,Mt=A(ae,b,F,w),ke=_(Ae(Yt,tt),C,I,U),zt=V(Mt-xt),qt=V(li(ke,mt)),R=V(ts(ke,mt)),S=qt-R;if(Yt!=null){let q=Yt<0?k:mn,ht=Yt<0?mn:k;Vt?(oe>0&&ie[Rt]!=null&&Q(Je.get(ie[Rt]),zt,R+Ri(oe/2),At,li(0,S-oe),q,ht),fe[Rt]!=null&&Q(he.get(fe[Rt]),zt,R+Ri(oe/2),At,li(0,S-oe),q,ht)):Q(Sn,zt,R+Ri(oe/2),At,li(0,S-oe),q,ht),st(f,m,Rt,zt-oe/2,R,At+oe,S)}}return oe>0?Se.stroke=Vt?Je:Sn:Vt||(Se._fill=p.width==0?p._fill:p._stroke??p._fill,Se.width=0),Se.fill=Vt?he:Sn,Se})}function z1(i,t){let e=Ae(t?.alignGaps,0);return(n,s,r,o)=>Ur(n,s,(a,l,c,h,u,d,f,m,v,g,p)=>{[r,o]=qh(c,r,o);let y=a.pxRound,M=W=>y(d(W,h,g,m)),b=W=>y(f(W,u,p,v)),C,A,_;h.ori==0?(C=jh,_=qo,A=t_):(C=Jh,_=$o,A=e_);let w=h.dir*(h.ori==0?1:-1),U=M(l[w==1?r:o]),F=U,I=[],V=[];for(let W=w==1?r:o;W>=r&&W<=o;W+=w)if(c[W]!=null){let j=l[W],Q=M(j);I.push(F=Q),V.push(b(c[W]))}let H={stroke:i(I,V,C,_,A,y),fill:null,clip:null,band:null,gaps:null,flags:Wo},N=H.stroke,[X,Y]=Wf(n,s);if(a.fill!=null||X!=0){let W=H.fill=new Path2D(N),ct=a.fillTo(n,s,a.min,a.max,X),j=b(ct);_(W,F,j),_(W,U,j)}if(!a.spanGaps){let W=[];W.push(...Xf(l,c,r,o,w,M,e)),H.gaps=W=a.gaps(n,s,r,o,W),H.clip=Kh(W,h.ori,m,v,g,p)}return Y!=0&&(H.band=Y==2?[Gs(n,s,r,o,N,-1),Gs(n,s,r,o,N,1)]:Gs(n,s,r,o,N,Y)),H})}function V1(i){return z1(G1,i)}function G1(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=t[d+1]-t[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+u[d]/3,t[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,t[d+1]-l[d+1]*u[d]/3,i[d+1],t[d+1])}return a}var Lf=new Set;function y0(){for(let i of Lf)i.syncRect(!0)}Xo&&(Nr(Sw,zo,y0),Nr(Mw,zo,y0,!0),Nr(Hh,zo,()=>{Hn.pxRatio=Re}));var H1=s_(),W1=n_();function v0(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>If(r,o,t,e))}function X1(i,t){return i.map((e,n)=>n==0?{}:bn({},t,e))}function If(i,t,e,n){return bn({},t==0?e:n,i)}function r_(i,t,e){return t==null?Go:[t,e]}var q1=r_;function $1(i,t,e){return t==null?Go:Wh(t,e,Of,!0)}function o_(i,t,e,n){return t==null?Go:$h(t,e,i.scales[n].log,!1)}var Y1=o_;function a_(i,t,e,n){return t==null?Go:Uf(t,e,i.scales[n].log,!1)}var Z1=a_;function K1(i,t,e,n,s){let r=li(Jg(i),Jg(t)),o=t-i,a=Qi(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?pr.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function b0(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=Cn((e=+s)*Re))+"px"),[i,t,e]}function j1(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Ve(t[2]*Re,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Hn(i,t,e){let n={mode:Ae(i.mode,1)},s=n.mode;function r(x,T,P,D){let G=T.valToPct(x);return D+P*(T.dir==-1?1-G:G)}function o(x,T,P,D){let G=T.valToPct(x);return D+P*(T.dir==-1?G:1-G)}function a(x,T,P,D){return T.ori==0?r(x,T,P,D):o(x,T,P,D)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=Oi(sw);if(i.id!=null&&(c.id=i.id),Ci(c,i.class),i.title){let x=Oi(aw,c);x.textContent=i.title}let h=Ji("canvas"),u=n.ctx=h.getContext("2d"),d=Oi(lw,c);Nr("click",d,x=>{x.target===m&&(Xe!=Zr||Qe!=Kr)&&zn.click(n,x)},!0);let f=n.under=Oi(cw,d);d.appendChild(h);let m=n.over=Oi(hw,d);i=Ho(i);let v=+Ae(i.pxAlign,1),g=_0(v);(i.plugins||[]).forEach(x=>{x.opts&&(i=x.opts(n,i)||i)});let p=i.ms||.001,y=n.series=s==1?v0(i.series||[],h0,m0,!1):X1(i.series||[null],p0),M=n.axes=v0(i.axes||[],c0,d0,!0),b=n.scales={},C=n.bands=i.bands||[];C.forEach(x=>{x.fill=ve(x.fill||null),x.dir=Ae(x.dir,-1)});let A=s==2?y[1].facets[0].scale:y[0].scale,_={axes:bs,series:me},w=(i.drawOrder||["axes","series"]).map(x=>_[x]);function U(x){let T=x.distr==3?P=>Vs(P>0?P:x.clamp(n,P,x.min,x.max,x.key)):x.distr==4?P=>yf(P,x.asinh):x.distr==100?P=>x.fwd(P):P=>P;return P=>{let D=T(P),{_min:G,_max:K}=x,at=K-G;return(D-G)/at}}function F(x){let T=b[x];if(T==null){let P=(i.scales||hl)[x]||hl;if(P.from!=null){F(P.from);let D=bn({},b[P.from],P,{key:x});D.valToPct=U(D),b[x]=D}else{T=b[x]=bn({},x==A?Z0:D1,P),T.key=x;let D=T.time,G=T.range,K=fr(G);if((x!=A||s==2&&!D)&&(K&&(G[0]==null||G[1]==null)&&(G={min:G[0]==null?Zg:{mode:1,hard:G[0],soft:G[0]},max:G[1]==null?Zg:{mode:1,hard:G[1],soft:G[1]}},K=!1),!K&&Zh(G))){let at=G;G=(ft,vt,Dt)=>vt==null?Go:Wh(vt,Dt,at)}T.range=ve(G||(D?q1:x==A?T.distr==3?Y1:T.distr==4?Z1:r_:T.distr==3?o_:T.distr==4?a_:$1)),T.auto=ve(K?!1:T.auto),T.clamp=ve(T.clamp||I1),T._min=T._max=null,T.valToPct=U(T)}}}F("x"),F("y"),s==1&&y.forEach(x=>{F(x.scale)}),M.forEach(x=>{F(x.scale)});for(let x in i.scales)F(x);let I=b[A],V=I.distr,H,N;I.ori==0?(Ci(c,rw),H=r,N=o):(Ci(c,ow),H=o,N=r);let X={};for(let x in b){let T=b[x];(T.min!=null||T.max!=null)&&(X[x]={min:T.min,max:T.max},T.min=T.max=null)}let Y=i.tzDate||(x=>new Date(Cn(x/p))),W=i.fmtDate||zf,ct=p==1?r1(Y):l1(Y),j=o0(Y,r0(p==1?s1:a1,W)),Q=l0(Y,a0(h1,W)),st=[],dt=n.legend=bn({},f1,i.legend),ut=n.cursor=bn({},y1,{drag:{y:s==2}},i.cursor),tt=dt.show,mt=ut.show,xt=dt.markers;dt.idxs=st,xt.width=ve(xt.width),xt.dash=ve(xt.dash),xt.stroke=ve(xt.stroke),xt.fill=ve(xt.fill);let At,St,Ht,oe=[],Vt=[],fe,he=!1,ie={};if(dt.live){let x=y[1]?y[1].values:null;he=x!=null,fe=he?x(n,1,0):{_:0};for(let T in fe)ie[T]=Nf}if(tt)if(At=Ji("table",gw,c),Ht=Ji("tbody",null,At),dt.mount(n,At),he){St=Ji("thead",null,At,Ht);let x=Ji("tr",null,St);Ji("th",null,x);for(var Je in fe)Ji("th",Ug,x).textContent=Je}else Ci(At,xw),dt.live&&Ci(At,_w);let Ge={show:!0},pn={show:!1};function Oe(x,T){if(T==0&&(he||!dt.live||s==2))return Go;let P=[],D=Ji("tr",yw,Ht,Ht.childNodes[T]);Ci(D,x.class),x.show||Ci(D,Dr);let G=Ji("th",null,D);if(xt.show){let ft=Oi(vw,G);if(T>0){let vt=xt.width(n,T);vt&&(ft.style.border=vt+"px "+xt.dash(n,T)+" "+xt.stroke(n,T)),ft.style.background=xt.fill(n,T)}}let K=Oi(Ug,G);x.label instanceof HTMLElement?K.appendChild(x.label):K.textContent=x.label,T>0&&(xt.show||(K.style.color=x.width>0?xt.stroke(n,T):xt.fill(n,T)),Se("click",G,ft=>{if(ut._lock)return;jt(ft);let vt=y.indexOf(x);if((ft.ctrlKey||ft.metaKey)!=dt.isolate){let Dt=y.some((Nt,Ut)=>Ut>0&&Ut!=vt&&Nt.show);y.forEach((Nt,Ut)=>{Ut>0&&ss(Ut,Dt?Ut==vt?Ge:pn:Ge,!0,yn.setSeries)})}else ss(vt,{show:!x.show},!0,yn.setSeries)},!1),Jt&&Se(zg,G,ft=>{ut._lock||(jt(ft),ss(y.indexOf(x),Jr,!0,yn.setSeries))},!1));for(var at in fe){let ft=Ji("td",bw,D);ft.textContent="--",P.push(ft)}return[D,P]}let Ln=new Map;function Se(x,T,P,D=!0){let G=Ln.get(T)||{},K=ut.bind[x](n,T,P,D);K&&(Nr(x,T,G[x]=K),Ln.set(T,G))}function Sn(x,T,P){let D=Ln.get(T)||{};for(let G in D)(x==null||G==x)&&(Ef(G,T,D[G]),delete D[G]);x==null&&Ln.delete(T)}let sn=0,mn=0,k=0,Rt=0,Yt=0,ae=0,Mt=Yt,ke=ae,zt=k,qt=Rt,R=0,S=0,q=0,ht=0;n.bbox={};let ot=!1,_t=!1,yt=!1,et=!1,it=!1,pt=!1;function B(x,T,P){(P||x!=n.width||T!=n.height)&&rt(x,T),ue(!1),yt=!0,_t=!0,$n()}function rt(x,T){n.width=sn=k=x,n.height=mn=Rt=T,Yt=ae=0,bt(),Gt();let P=n.bbox;R=P.left=Lr(Yt*Re,.5),S=P.top=Lr(ae*Re,.5),q=P.width=Lr(k*Re,.5),ht=P.height=Lr(Rt*Re,.5)}let nt=3;function wt(){let x=!1,T=0;for(;!x;){T++;let P=qr(T),D=is(T);x=T==nt||P&&D,x||(rt(n.width,n.height),_t=!0)}}function gt({width:x,height:T}){B(x,T)}n.setSize=gt;function bt(){let x=!1,T=!1,P=!1,D=!1;M.forEach((G,K)=>{if(G.show&&G._show){let{side:at,_size:ft}=G,vt=at%2,Dt=G.label!=null?G.labelSize:0,Nt=ft+Dt;Nt>0&&(vt?(k-=Nt,at==3?(Yt+=Nt,D=!0):P=!0):(Rt-=Nt,at==0?(ae+=Nt,x=!0):T=!0))}}),es[0]=x,es[1]=P,es[2]=T,es[3]=D,k-=ki[1]+ki[3],Yt+=ki[3],Rt-=ki[2]+ki[0],ae+=ki[0]}function Gt(){let x=Yt+k,T=ae+Rt,P=Yt,D=ae;function G(K,at){switch(K){case 1:return x+=at,x-at;case 2:return T+=at,T-at;case 3:return P-=at,P+at;case 0:return D-=at,D+at}}M.forEach((K,at)=>{if(K.show&&K._show){let ft=K.side;K._pos=G(ft,K._size),K.label!=null&&(K._lpos=G(ft,K.labelSize))}})}if(ut.dataIdx==null){let x=ut.hover,T=x.skip=new Set(x.skip??[]);T.add(void 0);let P=x.prox=ve(x.prox),D=x.bias??=0;ut.dataIdx=(G,K,at,ft)=>{if(K==0)return at;let vt=at,Dt=P(G,K,at,ft)??ze,Nt=Dt>=0&&Dt<ze,Ut=I.ori==0?k:Rt,se=ut.left,Ce=t[0],Te=t[K];if(T.has(Te[at])){vt=null;let ge=null,Kt=null,Wt;if(D==0||D==-1)for(Wt=at;ge==null&&Wt-- >0;)T.has(Te[Wt])||(ge=Wt);if(D==0||D==1)for(Wt=at;Kt==null&&Wt++<Te.length;)T.has(Te[Wt])||(Kt=Wt);if(ge!=null||Kt!=null)if(Nt){let $e=ge==null?-1/0:H(Ce[ge],I,Ut,0),an=Kt==null?1/0:H(Ce[Kt],I,Ut,0),Fn=se-$e,Be=an-se;Fn<=Be?Fn<=Dt&&(vt=ge):Be<=Dt&&(vt=Kt)}else vt=Kt==null?ge:ge==null?Kt:at-ge<=Kt-at?ge:Kt}else Nt&&Rn(se-H(Ce[at],I,Ut,0))>Dt&&(vt=null);return vt}}let jt=x=>{ut.event=x};ut.idxs=st,ut._lock=!1;let lt=ut.points;lt.show=ve(lt.show),lt.size=ve(lt.size),lt.stroke=ve(lt.stroke),lt.width=ve(lt.width),lt.fill=ve(lt.fill);let Ot=n.focus=bn({},i.focus||{alpha:.3},ut.focus),Jt=Ot.prox>=0,Ct=Jt&&lt.one,le=[],We=[],jn=[];function Jo(x,T){let P=lt.show(n,T);if(P instanceof HTMLElement)return Ci(P,mw),Ci(P,x.class),ps(P,-10,-10,k,Rt),m.insertBefore(P,le[T]),P}function Hr(x,T){if(s==1||T>0){let P=s==1&&b[x.scale].time,D=x.value;x.value=P?e0(D)?l0(Y,a0(D,W)):D||Q:D||R1,x.label=x.label||(P?b1:v1)}if(Ct||T>0){x.width=x.width==null?1:x.width,x.paths=x.paths||H1||Dw,x.fillTo=ve(x.fillTo||N1),x.pxAlign=+Ae(x.pxAlign,v),x.pxRound=_0(x.pxAlign),x.stroke=ve(x.stroke||null),x.fill=ve(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let P=P1(li(1,x.width),1),D=x.points=bn({},{size:P,width:li(1,P*.2),stroke:x.stroke,space:P*2,paths:W1,_stroke:null,_fill:null},x.points);D.show=ve(D.show),D.filter=ve(D.filter),D.fill=ve(D.fill),D.stroke=ve(D.stroke),D.paths=ve(D.paths),D.pxAlign=x.pxAlign}if(tt){let P=Oe(x,T);oe.splice(T,0,P[0]),Vt.splice(T,0,P[1]),dt.values.push(null)}if(mt){st.splice(T,0,null);let P=null;Ct?T==0&&(P=Jo(x,T)):T>0&&(P=Jo(x,T)),le.splice(T,0,P),We.splice(T,0,0),jn.splice(T,0,0)}Nn("addSeries",T)}function Pu(x,T){T=T??y.length,x=s==1?If(x,T,h0,m0):If(x,T,{},p0),y.splice(T,0,x),Hr(y[T],T)}n.addSeries=Pu;function xl(x){if(y.splice(x,1),tt){dt.values.splice(x,1),Vt.splice(x,1);let T=oe.splice(x,1)[0];Sn(null,T.firstChild),T.remove()}mt&&(st.splice(x,1),le.splice(x,1)[0].remove(),We.splice(x,1),jn.splice(x,1)),Nn("delSeries",x)}n.delSeries=xl;let es=[!1,!1,!1,!1];function xs(x,T){if(x._show=x.show,x.show){let P=x.side%2,D=b[x.scale];D==null&&(x.scale=P?y[1].scale:A,D=b[x.scale]);let G=D.time;x.size=ve(x.size),x.space=ve(x.space),x.rotate=ve(x.rotate),fr(x.incrs)&&x.incrs.forEach(at=>{!pr.has(at)&&pr.set(at,P0(at))}),x.incrs=ve(x.incrs||(D.distr==2?e1:G?p==1?i1:o1:Ir)),x.splits=ve(x.splits||(G&&D.distr==1?ct:D.distr==3?Cf:D.distr==4?w1:M1)),x.stroke=ve(x.stroke),x.grid.stroke=ve(x.grid.stroke),x.ticks.stroke=ve(x.ticks.stroke),x.border.stroke=ve(x.border.stroke);let K=x.values;x.values=fr(K)&&!fr(K[0])?ve(K):G?fr(K)?o0(Y,r0(K,W)):e0(K)?c1(Y,K):K||j:K||S1,x.filter=ve(x.filter||(D.distr>=3&&D.log==10?A1:D.distr==3&&D.log==2?C1:C0)),x.font=b0(x.font),x.labelFont=b0(x.labelFont),x._size=x.size(n,null,T,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(es[T]=!0,x._el=Oi(uw,d))}}function ys(x,T,P,D){let[G,K,at,ft]=P,vt=T%2,Dt=0;return vt==0&&(ft||K)&&(Dt=T==0&&!G||T==2&&!at?Cn(c0.size/3):0),vt==1&&(G||at)&&(Dt=T==1&&!K||T==3&&!ft?Cn(d0.size/2):0),Dt}let Qo=n.padding=(i.padding||[ys,ys,ys,ys]).map(x=>ve(Ae(x,ys))),ki=n._padding=Qo.map((x,T)=>x(n,T,es,0)),rn,cn=null,hn=null,ns=s==1?y[0].idxs:null,mi=null,Ws=!1;function ta(x,T){if(t=x??[],n.data=n._data=t,s==2){rn=0;for(let P=1;P<y.length;P++)rn+=t[P][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),mi=t[0],rn=mi.length;let P=t;if(V==2){P=t.slice();let D=P[0]=Array(rn);for(let G=0;G<rn;G++)D[G]=G}n._data=t=P}if(ue(!0),Nn("setData"),V==2&&(yt=!0),T!==!1){let P=I;P.auto(n,Ws)?ea():$s(A,P.min,P.max),et=et||ut.left>=0,pt=!0,$n()}}n.setData=ta;function ea(){Ws=!0;let x,T;s==1&&(rn>0?(cn=ns[0]=0,hn=ns[1]=rn-1,x=t[0][cn],T=t[0][hn],V==2?(x=cn,T=hn):x==T&&(V==3?[x,T]=$h(x,x,I.log,!1):V==4?[x,T]=Uf(x,x,I.log,!1):I.time?T=x+Cn(86400/p):[x,T]=Wh(x,T,Of,!0))):(cn=ns[0]=x=null,hn=ns[1]=T=null)),$s(A,x,T)}let Wr,Xs,Xr,E,z,J,$,Z,Tt,Lt;function Et(x,T,P,D,G,K){x??=Bg,P??=kf,D??="butt",G??=Bg,K??="round",x!=Wr&&(u.strokeStyle=Wr=x),G!=Xs&&(u.fillStyle=Xs=G),T!=Xr&&(u.lineWidth=Xr=T),K!=z&&(u.lineJoin=z=K),D!=J&&(u.lineCap=J=D),P!=E&&u.setLineDash(E=P)}function It(x,T,P,D){T!=Xs&&(u.fillStyle=Xs=T),x!=$&&(u.font=$=x),P!=Z&&(u.textAlign=Z=P),D!=Tt&&(u.textBaseline=Tt=D)}function kt(x,T,P,D,G=0){if(D.length>0&&x.auto(n,Ws)&&(T==null||T.min==null)){let K=Ae(cn,0),at=Ae(hn,D.length-1),ft=P.min==null?Aw(D,K,at,G,x.distr==3):[P.min,P.max];x.min=ts(x.min,P.min=ft[0]),x.max=li(x.max,P.max=ft[1])}}let te={min:null,max:null};function pe(){for(let D in b){let G=b[D];X[D]==null&&(G.min==null||X[A]!=null&&G.auto(n,Ws))&&(X[D]=te)}for(let D in b){let G=b[D];X[D]==null&&G.from!=null&&X[G.from]!=null&&(X[D]=te)}X[A]!=null&&ue(!0);let x={};for(let D in X){let G=X[D];if(G!=null){let K=x[D]=Ho(b[D],Uw);if(G.min!=null)bn(K,G);else if(D!=A||s==2)if(rn==0&&K.from==null){let at=K.range(n,null,null,D);K.min=at[0],K.max=at[1]}else K.min=ze,K.max=-ze}}if(rn>0){y.forEach((D,G)=>{if(s==1){let K=D.scale,at=X[K];if(at==null)return;let ft=x[K];if(G==0){let vt=ft.range(n,ft.min,ft.max,K);ft.min=vt[0],ft.max=vt[1],cn=Qi(ft.min,t[0]),hn=Qi(ft.max,t[0]),hn-cn>1&&(t[0][cn]<ft.min&&cn++,t[0][hn]>ft.max&&hn--),D.min=mi[cn],D.max=mi[hn]}else D.show&&D.auto&&kt(ft,at,D,t[G],D.sorted);D.idxs[0]=cn,D.idxs[1]=hn}else if(G>0&&D.show&&D.auto){let[K,at]=D.facets,ft=K.scale,vt=at.scale,[Dt,Nt]=t[G],Ut=x[ft],se=x[vt];Ut!=null&&kt(Ut,X[ft],K,Dt,K.sorted),se!=null&&kt(se,X[vt],at,Nt,at.sorted),D.min=at.min,D.max=at.max}});for(let D in x){let G=x[D],K=X[D];if(G.from==null&&(K==null||K.min==null)){let at=G.range(n,G.min==ze?null:G.min,G.max==-ze?null:G.max,D);G.min=at[0],G.max=at[1]}}}for(let D in x){let G=x[D];if(G.from!=null){let K=x[G.from];if(K.min==null)G.min=G.max=null;else{let at=G.range(n,K.min,K.max,D);G.min=at[0],G.max=at[1]}}}let T={},P=!1;for(let D in x){let G=x[D],K=b[D];if(K.min!=G.min||K.max!=G.max){K.min=G.min,K.max=G.max;let at=K.distr;K._min=at==3?Vs(K.min):at==4?yf(K.min,K.asinh):at==100?K.fwd(K.min):K.min,K._max=at==3?Vs(K.max):at==4?yf(K.max,K.asinh):at==100?K.fwd(K.max):K.max,T[D]=P=!0}}if(P){y.forEach((D,G)=>{s==2?G>0&&T.y&&(D._paths=null):T[D.scale]&&(D._paths=null)});for(let D in T)yt=!0,Nn("setScale",D);mt&&ut.left>=0&&(et=pt=!0)}for(let D in X)X[D]=null}function Bt(x){let T=Af(cn-1,0,rn-1),P=Af(hn+1,0,rn-1);for(;x[T]==null&&T>0;)T--;for(;x[P]==null&&P<rn-1;)P++;return[T,P]}function me(){if(rn>0){let x=y.some(T=>T._focus)&&Lt!=Ot.alpha;x&&(u.globalAlpha=Lt=Ot.alpha),y.forEach((T,P)=>{if(P>0&&T.show&&(nn(P,!1),nn(P,!0),T._paths==null)){let D=Lt;Lt!=T.alpha&&(u.globalAlpha=Lt=T.alpha);let G=s==2?[0,t[P][0].length-1]:Bt(t[P]);T._paths=T.paths(n,P,G[0],G[1]),Lt!=D&&(u.globalAlpha=Lt=D)}}),y.forEach((T,P)=>{if(P>0&&T.show){let D=Lt;Lt!=T.alpha&&(u.globalAlpha=Lt=T.alpha),T._paths!=null&&Ne(P,!1);{let G=T._paths!=null?T._paths.gaps:null,K=T.points.show(n,P,cn,hn,G),at=T.points.filter(n,P,K,G);(K||at)&&(T.points._paths=T.points.paths(n,P,cn,hn,at),Ne(P,!0))}Lt!=D&&(u.globalAlpha=Lt=D),Nn("drawSeries",P)}}),x&&(u.globalAlpha=Lt=1)}}function nn(x,T){let P=T?y[x].points:y[x];P._stroke=P.stroke(n,x),P._fill=P.fill(n,x)}function Ne(x,T){let P=T?y[x].points:y[x],{stroke:D,fill:G,clip:K,flags:at,_stroke:ft=P._stroke,_fill:vt=P._fill,_width:Dt=P.width}=P._paths;Dt=Ve(Dt*Re,3);let Nt=null,Ut=Dt%2/2;T&&vt==null&&(vt=Dt>0?"#fff":ft);let se=P.pxAlign==1&&Ut>0;if(se&&u.translate(Ut,Ut),!T){let Ce=R-Dt/2,Te=S-Dt/2,ge=q+Dt,Kt=ht+Dt;Nt=new Path2D,Nt.rect(Ce,Te,ge,Kt)}T?Ft(ft,Dt,P.dash,P.cap,vt,D,G,at,K):Fe(x,ft,Dt,P.dash,P.cap,vt,D,G,at,Nt,K),se&&u.translate(-Ut,-Ut)}function Fe(x,T,P,D,G,K,at,ft,vt,Dt,Nt){let Ut=!1;vt!=0&&C.forEach((se,Ce)=>{if(se.series[0]==x){let Te=y[se.series[1]],ge=t[se.series[1]],Kt=(Te._paths||hl).band;fr(Kt)&&(Kt=se.dir==1?Kt[0]:Kt[1]);let Wt,$e=null;Te.show&&Kt&&Rw(ge,cn,hn)?($e=se.fill(n,Ce)||K,Wt=Te._paths.clip):Kt=null,Ft(T,P,D,G,$e,at,ft,vt,Dt,Nt,Wt,Kt),Ut=!0}}),Ut||Ft(T,P,D,G,K,at,ft,vt,Dt,Nt)}let Mn=Wo|Pf;function Ft(x,T,P,D,G,K,at,ft,vt,Dt,Nt,Ut){Et(x,T,P,D,G),(vt||Dt||Ut)&&(u.save(),vt&&u.clip(vt),Dt&&u.clip(Dt)),Ut?(ft&Mn)==Mn?(u.clip(Ut),Nt&&u.clip(Nt),_e(G,at),gn(x,K,T)):ft&Pf?(_e(G,at),u.clip(Ut),gn(x,K,T)):ft&Wo&&(u.save(),u.clip(Ut),Nt&&u.clip(Nt),_e(G,at),u.restore(),gn(x,K,T)):(_e(G,at),gn(x,K,T)),(vt||Dt||Ut)&&u.restore()}function gn(x,T,P){P>0&&(T instanceof Map?T.forEach((D,G)=>{u.strokeStyle=Wr=G,u.stroke(D)}):T!=null&&x&&u.stroke(T))}function _e(x,T){T instanceof Map?T.forEach((P,D)=>{u.fillStyle=Xs=D,u.fill(P)}):T!=null&&x&&u.fill(T)}function vs(x,T,P,D){let G=M[x],K;if(D<=0)K=[0,0];else{let at=G._space=G.space(n,x,T,P,D),ft=G._incrs=G.incrs(n,x,T,P,D,at);K=K1(T,P,ft,D,at)}return G._found=K}function _n(x,T,P,D,G,K,at,ft,vt,Dt){let Nt=at%2/2;v==1&&u.translate(Nt,Nt),Et(ft,at,vt,Dt,ft),u.beginPath();let Ut,se,Ce,Te,ge=G+(D==0||D==3?-K:K);P==0?(se=G,Te=ge):(Ut=G,Ce=ge);for(let Kt=0;Kt<x.length;Kt++)T[Kt]!=null&&(P==0?Ut=Ce=x[Kt]:se=Te=x[Kt],u.moveTo(Ut,se),u.lineTo(Ce,Te));u.stroke(),v==1&&u.translate(-Nt,-Nt)}function qr(x){let T=!0;return M.forEach((P,D)=>{if(!P.show)return;let G=b[P.scale];if(G.min==null){P._show&&(T=!1,P._show=!1,ue(!1));return}else P._show||(T=!1,P._show=!0,ue(!1));let K=P.side,at=K%2,{min:ft,max:vt}=G,[Dt,Nt]=vs(D,ft,vt,at==0?k:Rt);if(Nt==0)return;let Ut=G.distr==2,se=P._splits=P.splits(n,D,ft,vt,Dt,Nt,Ut),Ce=G.distr==2?se.map(Wt=>mi[Wt]):se,Te=G.distr==2?mi[se[1]]-mi[se[0]]:Dt,ge=P._values=P.values(n,P.filter(n,Ce,D,Nt,Te),D,Nt,Te);P._rotate=K==2?P.rotate(n,ge,D,Nt):0;let Kt=P._size;P._size=Bi(P.size(n,ge,D,x)),Kt!=null&&P._size!=Kt&&(T=!1)}),T}function is(x){let T=!0;return Qo.forEach((P,D)=>{let G=P(n,D,es,x);G!=ki[D]&&(T=!1),ki[D]=G}),T}function bs(){for(let x=0;x<M.length;x++){let T=M[x];if(!T.show||!T._show)continue;let P=T.side,D=P%2,G,K,at=T.stroke(n,x),ft=P==0||P==3?-1:1,[vt,Dt]=T._found;if(T.label!=null){let ti=T.labelGap*ft,xi=Cn((T._lpos+ti)*Re);It(T.labelFont[0],at,"center",P==2?"top":Og),u.save(),D==1?(G=K=0,u.translate(xi,Cn(S+ht/2)),u.rotate((P==3?-Gh:Gh)/2)):(G=Cn(R+q/2),K=xi);let xr=E0(T.label)?T.label(n,x,vt,Dt):T.label;u.fillText(xr,G,K),u.restore()}if(Dt==0)continue;let Nt=b[T.scale],Ut=D==0?q:ht,se=D==0?R:S,Ce=T._splits,Te=Nt.distr==2?Ce.map(ti=>mi[ti]):Ce,ge=Nt.distr==2?mi[Ce[1]]-mi[Ce[0]]:vt,Kt=T.ticks,Wt=T.border,$e=Kt.show?Kt.size:0,an=Cn($e*Re),Fn=Cn((T.alignTo==2?T._size-$e-T.gap:T.gap)*Re),Be=T._rotate*-Gh/180,ln=g(T._pos*Re),gi=(an+Fn)*ft,Qn=ln+gi;K=D==0?Qn:0,G=D==1?Qn:0;let Li=T.font[0],zi=T.align==1?Bo:T.align==2?gf:Be>0?Bo:Be<0?gf:D==0?"center":P==3?gf:Bo,os=Be||D==1?"middle":P==2?"top":Og;It(Li,at,zi,os);let _i=T.font[1]*T.lineGap,Ii=Ce.map(ti=>g(a(ti,Nt,Ut,se))),Vi=T._values;for(let ti=0;ti<Vi.length;ti++){let xi=Vi[ti];if(xi!=null){D==0?G=Ii[ti]:K=Ii[ti],xi=""+xi;let xr=xi.indexOf(`
`)==-1?[xi]:xi.split(/\n/gm);for(let ei=0;ei<xr.length;ei++){let Sp=xr[ei];Be?(u.save(),u.translate(G,K+ei*_i),u.rotate(Be),u.fillText(Sp,0,0),u.restore()):u.fillText(Sp,G,K+ei*_i)}}}Kt.show&&_n(Ii,Kt.filter(n,Te,x,Dt,ge),D,P,ln,an,Ve(Kt.width*Re,3),Kt.stroke(n,x),Kt.dash,Kt.cap);let as=T.grid;as.show&&_n(Ii,as.filter(n,Te,x,Dt,ge),D,D==0?2:1,D==0?S:R,D==0?ht:q,Ve(as.width*Re,3),as.stroke(n,x),as.dash,as.cap),Wt.show&&_n([ln],[1],D==0?1:0,D==0?1:2,D==1?S:R,D==1?ht:q,Ve(Wt.width*Re,3),Wt.stroke(n,x),Wt.dash,Wt.cap)}Nn("drawAxes")}function ue(x){y.forEach((T,P)=>{P>0&&(T._paths=null,x&&(s==1?(T.min=null,T.max=null):T.facets.forEach(D=>{D.min=null,D.max=null})))})}let on=!1,Jn=!1,Ue=[];function xn(){Jn=!1;for(let x=0;x<Ue.length;x++)Nn(...Ue[x]);Ue.length=0}function $n(){on||(Hw(sp),on=!0)}function yl(x,T=!1){on=!0,Jn=T,x(n),sp(),T&&Ue.length>0&&queueMicrotask(xn)}n.batch=yl;function sp(){if(ot&&(pe(),ot=!1),yt&&(wt(),yt=!1),_t){if(je(f,Bo,Yt),je(f,"top",ae),je(f,ol,k),je(f,al,Rt),je(m,Bo,Yt),je(m,"top",ae),je(m,ol,k),je(m,al,Rt),je(d,ol,sn),je(d,al,mn),h.width=Cn(sn*Re),h.height=Cn(mn*Re),M.forEach(({_el:x,_show:T,_size:P,_pos:D,side:G})=>{if(x!=null)if(T){let K=G===3||G===0?P:0,at=G%2==1;je(x,at?"left":"top",D-K),je(x,at?"width":"height",P),je(x,at?"top":"left",at?ae:Yt),je(x,at?"height":"width",at?Rt:k),Tf(x,Dr)}else Ci(x,Dr)}),Wr=Xs=Xr=z=J=$=Z=Tt=E=null,Lt=1,sa(!0),Yt!=Mt||ae!=ke||k!=zt||Rt!=qt){ue(!1);let x=k/zt,T=Rt/qt;if(mt&&!et&&ut.left>=0){ut.left*=x,ut.top*=T,$r&&ps($r,Cn(ut.left),0,k,Rt),Yr&&ps(Yr,0,Cn(ut.top),k,Rt);for(let P=0;P<le.length;P++){let D=le[P];D!=null&&(We[P]*=x,jn[P]*=T,ps(D,Bi(We[P]),Bi(jn[P]),k,Rt))}}if(qe.show&&!it&&qe.left>=0&&qe.width>0){qe.left*=x,qe.width*=x,qe.top*=T,qe.height*=T;for(let P in Uu)je(jr,P,qe[P])}Mt=Yt,ke=ae,zt=k,qt=Rt}Nn("setSize"),_t=!1}sn>0&&mn>0&&(u.clearRect(0,0,h.width,h.height),Nn("drawClear"),w.forEach(x=>x()),Nn("draw")),qe.show&&it&&(vl(qe),it=!1),mt&&et&&(_r(null,!0,!1),et=!1),dt.show&&dt.live&&pt&&(Nu(),pt=!1),l||(l=!0,n.status=1,Nn("ready")),Ws=!1,on=!1}n.redraw=(x,T)=>{yt=T||!1,x!==!1?$s(A,I.min,I.max):$n()};function Lu(x,T){let P=b[x];if(P.from==null){if(rn==0){let D=P.range(n,T.min,T.max,x);T.min=D[0],T.max=D[1]}if(T.min>T.max){let D=T.min;T.min=T.max,T.max=D}if(rn>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;x==A&&P.distr==2&&rn>0&&(T.min=Qi(T.min,t[0]),T.max=Qi(T.max,t[0]),T.min==T.max&&T.max++),X[x]=T,ot=!0,$n()}}n.setScale=Lu;let Iu,Du,$r,Yr,rp,op,Zr,Kr,ap,lp,Xe,Qe,qs=!1,zn=ut.drag,In=zn.x,Dn=zn.y;mt&&(ut.x&&(Iu=Oi(fw,m)),ut.y&&(Du=Oi(pw,m)),I.ori==0?($r=Iu,Yr=Du):($r=Du,Yr=Iu),Xe=ut.left,Qe=ut.top);let qe=n.select=bn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),jr=qe.show?Oi(dw,qe.over?m:f):null;function vl(x,T){if(qe.show){for(let P in x)qe[P]=x[P],P in Uu&&je(jr,P,x[P]);T!==!1&&Nn("setSelect")}}n.setSelect=vl;function N_(x){if(y[x].show)tt&&Tf(oe[x],Dr);else if(tt&&Ci(oe[x],Dr),mt){let P=Ct?le[0]:le[x];P!=null&&ps(P,-10,-10,k,Rt)}}function $s(x,T,P){Lu(x,{min:T,max:P})}function ss(x,T,P,D){T.focus!=null&&k_(x),T.show!=null&&y.forEach((G,K)=>{K>0&&(x==K||x==null)&&(G.show=T.show,N_(K),s==2?($s(G.facets[0].scale,null,null),$s(G.facets[1].scale,null,null)):$s(G.scale,null,null),$n())}),P!==!1&&Nn("setSeries",x,T),D&&ra("setSeries",n,x,T)}n.setSeries=ss;function F_(x,T){bn(C[x],T)}function U_(x,T){x.fill=ve(x.fill||null),x.dir=Ae(x.dir,-1),T=T??C.length,C.splice(T,0,x)}function O_(x){x==null?C.length=0:C.splice(x,1)}n.addBand=U_,n.setBand=F_,n.delBand=O_;function B_(x,T){y[x].alpha=T,mt&&le[x]!=null&&(le[x].style.opacity=T),tt&&oe[x]&&(oe[x].style.opacity=T)}let Ss,Ys,gr,Jr={focus:!0};function k_(x){if(x!=gr){let T=x==null,P=Ot.alpha!=1;y.forEach((D,G)=>{if(s==1||G>0){let K=T||G==0||G==x;D._focus=T?null:K,P&&B_(G,K?1:Ot.alpha)}}),gr=x,P&&$n()}}tt&&Jt&&Se(Vg,At,x=>{ut._lock||(jt(x),gr!=null&&ss(null,Jr,!0,yn.setSeries))});function rs(x,T,P){let D=b[T];P&&(x=x/Re-(D.ori==1?ae:Yt));let G=k;D.ori==1&&(G=Rt,x=G-x),D.dir==-1&&(x=G-x);let K=D._min,at=D._max,ft=x/G,vt=K+(at-K)*ft,Dt=D.distr;return Dt==3?Vo(10,vt):Dt==4?Lw(vt,D.asinh):Dt==100?D.bwd(vt):vt}function z_(x,T){let P=rs(x,A,T);return Qi(P,t[0],cn,hn)}n.valToIdx=x=>Qi(x,t[0]),n.posToIdx=z_,n.posToVal=rs,n.valToPos=(x,T,P)=>b[T].ori==0?r(x,b[T],P?q:k,P?R:0):o(x,b[T],P?ht:Rt,P?S:0),n.setCursor=(x,T,P)=>{Xe=x.left,Qe=x.top,_r(null,T,P)};function cp(x,T){je(jr,Bo,qe.left=x),je(jr,ol,qe.width=T)}function hp(x,T){je(jr,"top",qe.top=x),je(jr,al,qe.height=T)}let na=I.ori==0?cp:hp,ia=I.ori==1?cp:hp;function V_(){if(tt&&dt.live)for(let x=s==2?1:0;x<y.length;x++){if(x==0&&he)continue;let T=dt.values[x],P=0;for(let D in T)Vt[x][P++].firstChild.nodeValue=T[D]}}function Nu(x,T){if(x!=null&&(x.idxs?x.idxs.forEach((P,D)=>{st[D]=P}):Fw(x.idx)||st.fill(x.idx),dt.idx=st[0]),tt&&dt.live){for(let P=0;P<y.length;P++)(P>0||s==1&&!he)&&G_(P,st[P]);V_()}pt=!1,T!==!1&&Nn("setLegend")}n.setLegend=Nu;function G_(x,T){let P=y[x],D=x==0&&V==2?mi:t[x],G;he?G=P.values(n,x,T)??ie:(G=P.value(n,T==null?null:D[T],x,T),G=G==null?ie:{_:G}),dt.values[x]=G}function _r(x,T,P){ap=Xe,lp=Qe,[Xe,Qe]=ut.move(n,Xe,Qe),ut.left=Xe,ut.top=Qe,mt&&($r&&ps($r,Cn(Xe),0,k,Rt),Yr&&ps(Yr,0,Cn(Qe),k,Rt));let D,G=cn>hn;Ss=ze,Ys=null;let K=I.ori==0?k:Rt,at=I.ori==1?k:Rt;if(Xe<0||rn==0||G){D=ut.idx=null;for(let ft=0;ft<y.length;ft++){let vt=le[ft];vt!=null&&ps(vt,-10,-10,k,Rt)}Jt&&ss(null,Jr,!0,x==null&&yn.setSeries),dt.live&&(st.fill(D),pt=!0)}else{let ft,vt,Dt;s==1&&(ft=I.ori==0?Xe:Qe,vt=rs(ft,A),D=ut.idx=Qi(vt,t[0],cn,hn),Dt=H(t[0][D],I,K,0));let Nt=-10,Ut=-10,se=0,Ce=0,Te=!0,ge="",Kt="";for(let Wt=s==2?1:0;Wt<y.length;Wt++){let $e=y[Wt],an=st[Wt],Fn=an==null?null:s==1?t[Wt][an]:t[Wt][1][an],Be=ut.dataIdx(n,Wt,D,vt),ln=Be==null?null:s==1?t[Wt][Be]:t[Wt][1][Be];if(pt=pt||ln!=Fn||Be!=an,st[Wt]=Be,Wt>0&&$e.show){let gi=Be==null?-10:Be==D?Dt:H(s==1?t[0][Be]:t[Wt][0][Be],I,K,0),Qn=ln==null?-10:N(ln,s==1?b[$e.scale]:b[$e.facets[1].scale],at,0);if(Jt&&ln!=null){let Li=I.ori==1?Xe:Qe,zi=Rn(Ot.dist(n,Wt,Be,Qn,Li));if(zi<Ss){let os=Ot.bias;if(os!=0){let _i=rs(Li,$e.scale),Ii=ln>=0?1:-1,Vi=_i>=0?1:-1;Vi==Ii&&(Vi==1?os==1?ln>=_i:ln<=_i:os==1?ln<=_i:ln>=_i)&&(Ss=zi,Ys=Wt)}else Ss=zi,Ys=Wt}}if(pt||Ct){let Li,zi;I.ori==0?(Li=gi,zi=Qn):(Li=Qn,zi=gi);let os,_i,Ii,Vi,as,ti,xi=!0,xr=lt.bbox;if(xr!=null){xi=!1;let ei=xr(n,Wt);Ii=ei.left,Vi=ei.top,os=ei.width,_i=ei.height}else Ii=Li,Vi=zi,os=_i=lt.size(n,Wt);if(ti=lt.fill(n,Wt),as=lt.stroke(n,Wt),Ct)Wt==Ys&&Ss<=Ot.prox&&(Nt=Ii,Ut=Vi,se=os,Ce=_i,Te=xi,ge=ti,Kt=as);else{let ei=le[Wt];ei!=null&&(We[Wt]=Ii,jn[Wt]=Vi,Yg(ei,os,_i,xi),qg(ei,ti,as),ps(ei,Bi(Ii),Bi(Vi),k,Rt))}}}}if(Ct){let Wt=Ot.prox,$e=gr==null?Ss<=Wt:Ss>Wt||Ys!=gr;if(pt||$e){let an=le[0];an!=null&&(We[0]=Nt,jn[0]=Ut,Yg(an,se,Ce,Te),qg(an,ge,Kt),ps(an,Bi(Nt),Bi(Ut),k,Rt))}}}if(qe.show&&qs)if(x!=null){let[ft,vt]=yn.scales,[Dt,Nt]=yn.match,[Ut,se]=x.cursor.sync.scales,Ce=x.cursor.drag;if(In=Ce._x,Dn=Ce._y,In||Dn){let{left:Te,top:ge,width:Kt,height:Wt}=x.select,$e=x.scales[Ut].ori,an=x.posToVal,Fn,Be,ln,gi,Qn,Li=ft!=null&&Dt(ft,Ut),zi=vt!=null&&Nt(vt,se);Li&&In?($e==0?(Fn=Te,Be=Kt):(Fn=ge,Be=Wt),ln=b[ft],gi=H(an(Fn,Ut),ln,K,0),Qn=H(an(Fn+Be,Ut),ln,K,0),na(ts(gi,Qn),Rn(Qn-gi))):na(0,K),zi&&Dn?($e==1?(Fn=Te,Be=Kt):(Fn=ge,Be=Wt),ln=b[vt],gi=N(an(Fn,se),ln,at,0),Qn=N(an(Fn+Be,se),ln,at,0),ia(ts(gi,Qn),Rn(Qn-gi))):ia(0,at)}else Ou()}else{let ft=Rn(ap-rp),vt=Rn(lp-op);if(I.ori==1){let se=ft;ft=vt,vt=se}In=zn.x&&ft>=zn.dist,Dn=zn.y&&vt>=zn.dist;let Dt=zn.uni;Dt!=null?In&&Dn&&(In=ft>=Dt,Dn=vt>=Dt,!In&&!Dn&&(vt>ft?Dn=!0:In=!0)):zn.x&&zn.y&&(In||Dn)&&(In=Dn=!0);let Nt,Ut;In&&(I.ori==0?(Nt=Zr,Ut=Xe):(Nt=Kr,Ut=Qe),na(ts(Nt,Ut),Rn(Ut-Nt)),Dn||ia(0,at)),Dn&&(I.ori==1?(Nt=Zr,Ut=Xe):(Nt=Kr,Ut=Qe),ia(ts(Nt,Ut),Rn(Ut-Nt)),In||na(0,K)),!In&&!Dn&&(na(0,0),ia(0,0))}if(zn._x=In,zn._y=Dn,x==null){if(P){if(bp!=null){let[ft,vt]=yn.scales;yn.values[0]=ft!=null?rs(I.ori==0?Xe:Qe,ft):null,yn.values[1]=vt!=null?rs(I.ori==1?Xe:Qe,vt):null}ra(_f,n,Xe,Qe,k,Rt,D)}if(Jt){let ft=P&&yn.setSeries,vt=Ot.prox;gr==null?Ss<=vt&&ss(Ys,Jr,!0,ft):Ss>vt?ss(null,Jr,!0,ft):Ys!=gr&&ss(Ys,Jr,!0,ft)}}pt&&(dt.idx=D,Nu()),T!==!1&&Nn("setCursor")}let Zs=null;Object.defineProperty(n,"rect",{get(){return Zs==null&&sa(!1),Zs}});function sa(x=!1){x?Zs=null:(Zs=m.getBoundingClientRect(),Nn("syncRect",Zs))}function up(x,T,P,D,G,K,at){ut._lock||qs&&x!=null&&x.movementX==0&&x.movementY==0||(Fu(x,T,P,D,G,K,at,!1,x!=null),x!=null?_r(null,!0,!0):_r(T,!0,!1))}function Fu(x,T,P,D,G,K,at,ft,vt){if(Zs==null&&sa(!1),jt(x),x!=null)P=x.clientX-Zs.left,D=x.clientY-Zs.top;else{if(P<0||D<0){Xe=-10,Qe=-10;return}let[Dt,Nt]=yn.scales,Ut=T.cursor.sync,[se,Ce]=Ut.values,[Te,ge]=Ut.scales,[Kt,Wt]=yn.match,$e=T.axes[0].side%2==1,an=I.ori==0?k:Rt,Fn=I.ori==1?k:Rt,Be=$e?K:G,ln=$e?G:K,gi=$e?D:P,Qn=$e?P:D;if(Te!=null?P=Kt(Dt,Te)?a(se,b[Dt],an,0):-10:P=an*(gi/Be),ge!=null?D=Wt(Nt,ge)?a(Ce,b[Nt],Fn,0):-10:D=Fn*(Qn/ln),I.ori==1){let Li=P;P=D,D=Li}}vt&&(T==null||T.cursor.event.type==_f)&&((P<=1||P>=k-1)&&(P=Lr(P,k)),(D<=1||D>=Rt-1)&&(D=Lr(D,Rt))),ft?(rp=P,op=D,[Zr,Kr]=ut.move(n,P,D)):(Xe=P,Qe=D)}let Uu={width:0,height:0,left:0,top:0};function Ou(){vl(Uu,!1)}let dp,fp,pp,mp;function gp(x,T,P,D,G,K,at){qs=!0,In=Dn=zn._x=zn._y=!1,Fu(x,T,P,D,G,K,at,!0,!1),x!=null&&(Se(xf,Mf,_p,!1),ra(kg,n,Zr,Kr,k,Rt,null));let{left:ft,top:vt,width:Dt,height:Nt}=qe;dp=ft,fp=vt,pp=Dt,mp=Nt}function _p(x,T,P,D,G,K,at){qs=zn._x=zn._y=!1,Fu(x,T,P,D,G,K,at,!1,!0);let{left:ft,top:vt,width:Dt,height:Nt}=qe,Ut=Dt>0||Nt>0,se=dp!=ft||fp!=vt||pp!=Dt||mp!=Nt;if(Ut&&se&&vl(qe),zn.setScale&&Ut&&se){let Ce=ft,Te=Dt,ge=vt,Kt=Nt;if(I.ori==1&&(Ce=vt,Te=Nt,ge=ft,Kt=Dt),In&&$s(A,rs(Ce,A),rs(Ce+Te,A)),Dn)for(let Wt in b){let $e=b[Wt];Wt!=A&&$e.from==null&&$e.min!=ze&&$s(Wt,rs(ge+Kt,Wt),rs(ge,Wt))}Ou()}else ut.lock&&(ut._lock=!ut._lock,_r(T,!0,x!=null));x!=null&&(Sn(xf,Mf),ra(xf,n,Xe,Qe,k,Rt,null))}function H_(x,T,P,D,G,K,at){if(ut._lock)return;jt(x);let ft=qs;if(qs){let vt=!0,Dt=!0,Nt=10,Ut,se;I.ori==0?(Ut=In,se=Dn):(Ut=Dn,se=In),Ut&&se&&(vt=Xe<=Nt||Xe>=k-Nt,Dt=Qe<=Nt||Qe>=Rt-Nt),Ut&&vt&&(Xe=Xe<Zr?0:k),se&&Dt&&(Qe=Qe<Kr?0:Rt),_r(null,!0,!0),qs=!1}Xe=-10,Qe=-10,st.fill(null),_r(null,!0,!0),ft&&(qs=ft)}function xp(x,T,P,D,G,K,at){ut._lock||(jt(x),ea(),Ou(),x!=null&&ra(Gg,n,Xe,Qe,k,Rt,null))}function yp(){M.forEach(j1),B(n.width,n.height,!0)}Nr(Hh,zo,yp);let Qr={};Qr.mousedown=gp,Qr.mousemove=up,Qr.mouseup=_p,Qr.dblclick=xp,Qr.setSeries=(x,T,P,D)=>{let G=yn.match[2];P=G(n,T,P),P!=-1&&ss(P,D,!0,!1)},mt&&(Se(kg,m,gp),Se(_f,m,up),Se(zg,m,x=>{jt(x),sa(!1)}),Se(Vg,m,H_),Se(Gg,m,xp),Lf.add(n),n.syncRect=sa);let bl=n.hooks=i.hooks||{};function Nn(x,T,P){Jn?Ue.push([x,T,P]):x in bl&&bl[x].forEach(D=>{D.call(null,n,T,P)})}(i.plugins||[]).forEach(x=>{for(let T in x.hooks)bl[T]=(bl[T]||[]).concat(x.hooks[T])});let vp=(x,T,P)=>P,yn=bn({key:null,setSeries:!1,filters:{pub:Qg,sub:Qg},scales:[A,y[1]?y[1].scale:null],match:[t0,t0,vp],values:[null,null]},ut.sync);yn.match.length==2&&yn.match.push(vp),ut.sync=yn;let bp=yn.key,Bu=K0(bp);function ra(x,T,P,D,G,K,at){yn.filters.pub(x,T,P,D,G,K,at)&&Bu.pub(x,T,P,D,G,K,at)}Bu.sub(n);function W_(x,T,P,D,G,K,at){yn.filters.sub(x,T,P,D,G,K,at)&&Qr[x](null,T,P,D,G,K,at)}n.pub=W_;function X_(){Bu.unsub(n),Lf.delete(n),Ln.clear(),Ef(Hh,zo,yp),c.remove(),At?.remove(),Nn("destroy")}n.destroy=X_;function ku(){Nn("init",i,t),ta(t||i.data,!1),X[A]?Lu(A,X[A]):ea(),it=qe.show&&(qe.width>0||qe.height>0),et=pt=!0,B(i.width,i.height)}return y.forEach(Hr),M.forEach(xs),e?e instanceof HTMLElement?(e.appendChild(c),ku()):e(n,ku):ku(),n}Hn.assign=bn;Hn.fmtNum=Bf;Hn.rangeNum=Wh;Hn.rangeLog=$h;Hn.rangeAsinh=Uf;Hn.orient=Ur;Hn.pxRatio=Re;Hn.join=Gw;Hn.fmtDate=zf,Hn.tzDate=Qw;Hn.sync=K0;{Hn.addGap=F1,Hn.clipGaps=Kh;let i=Hn.paths={points:n_};i.linear=s_,i.stepped=B1,i.bars=k1,i.spline=V1}var tu="not compared",eu=class{constructor(t,e,n,s){this.program=t;this.timeline=e;this.hover=n;this.theme=s;this.xValues=t.timeS,this.tabs=eT(t),this.tabButtons=this.tabs.map((a,l)=>{let c=L("button",{type:"button",role:"tab",id:`plot-tab-${a.name}`,"aria-controls":"plots"},a.label);return c.addEventListener("click",()=>this.open(l)),c.addEventListener("keydown",h=>{let u={ArrowRight:1,ArrowLeft:-1}[h.key];if(u===void 0)return;h.preventDefault(),h.stopPropagation();let d=(l+u+this.tabs.length)%this.tabs.length;this.open(d),this.tabButtons[d].focus()}),c}),this.axisButton=dn({label:"over time",key:"X",press:()=>this.toggleAxis()}),this.limitsButton=dn({label:"to limits",press:()=>this.toggleLimits()}),this.limitsButton.title="Scale the plots so that the limits are in sight",this.limitsButton.setAttribute("aria-pressed","false");let r=L("div",{class:"plot-tools"},this.axisButton,this.limitsButton,dn({label:"\u2212",key:"]",press:()=>this.zoomBy(2)}),dn({label:"+",key:"[",press:()=>this.zoomBy(.5)}),dn({label:"all",key:"\\",press:()=>this.setZoom(null)}));this.root.append(L("header",{},L("div",{role:"tablist","aria-label":"Plots",class:"tabs"},...this.tabButtons),r),this.stack),n.onChange(()=>this.showHover());let o=0;new ResizeObserver(()=>{cancelAnimationFrame(o),o=requestAnimationFrame(()=>this.resize())}).observe(this.stack),this.open(0)}program;timeline;hover;theme;root=L("section",{class:"plots","aria-label":"Plots"});stack=L("div",{class:"plot-stack",id:"plots",tabindex:"0",role:"region","aria-label":"Plots, with linked cursor"});tabs;tabButtons;axisButton;limitsButton;charts=[];tab=0;x="time";toLimits=!1;xValues;zoom=null;zooming=!1;linking=!1;update(){let t=this.timeline.position;this.zoom&&this.follow();let e=this.program.axesBetween(t);for(let{plot:n,curve:s,readout:r}of this.charts){let o=Math.floor(t),a=this.program.axes.indexOf(s.values),l=a>=0?e[a]:s.values[Math.ceil(t)]??s.values[o];r.textContent=s.values===this.program.errorUm&&this.program.isNotCompared(Math.ceil(t))?tu:`${He(l,s.decimals)} ${s.unit}`,r.classList.toggle("outside",s.limits.some(c=>Q1(l,c,Math.ceil(t)))),this.placeNow(n)}}restyle(t){this.theme=t,this.open(this.tab)}toggleAxis(){this.x=this.x==="time"?"block":"time",this.xValues=this.x==="time"?this.program.timeS:this.program.blockShare,this.axisButton.textContent=this.x==="time"?"over time":"over blocks",this.zoom=null,this.open(this.tab)}nextTab(){this.open((this.tab+1)%this.tabs.length)}zoomBy(t){let[e,n]=this.zoom??this.whole(),s=this.xAt(this.timeline.position),r=s>=e&&s<=n?s:(e+n)/2;this.setZoom([r-(r-e)*t,r+(n-r)*t])}setZoom(t){let[e,n]=this.whole(),s=t;if(s&&(s=[Math.max(s[0],e),Math.min(s[1],n)]),s&&s[1]-s[0]>=(n-e)*.999&&(s=null),s&&s[1]-s[0]<(n-e)*1e-7)return;this.zoom=s;let[r,o]=s??this.whole();this.zooming=!0;for(let{plot:a}of this.charts)a.setScale("x",{min:r,max:o});this.zooming=!1,this.update(),this.showHover()}toggleLimits(){this.toLimits=!this.toLimits,this.limitsButton.setAttribute("aria-pressed",String(this.toLimits)),this.open(this.tab)}whole(){let t=this.program.count-1,[e,n]=[this.xValues[0]??0,this.xValues[t]??1];return n>e?[e,n]:[e,e+1]}xAt(t){let e=Math.floor(t),n=Math.min(e+1,this.program.count-1);return this.xValues[e]+(t-e)*(this.xValues[n]-this.xValues[e])}pointAt(t){return Math.min(Es(this.xValues,t),this.program.count-1)}follow(){if(!this.zoom||this.zooming)return;let t=this.xAt(this.timeline.position),[e,n]=this.zoom;if(t>=e&&t<=n)return;let[s,r]=this.whole(),o=n-e,a=Math.min(Math.max(t-.2*o,s),r-o);this.setZoom([a,a+o])}open(t){this.tab=t,this.tabButtons.forEach((n,s)=>{n.setAttribute("aria-selected",String(s===t)),n.tabIndex=s===t?0:-1});for(let{plot:n}of this.charts)n.destroy();this.charts=[],this.stack.replaceChildren(),this.stack.setAttribute("aria-label",this.tabs[t].label);let{curves:e}=this.tabs[t];e.forEach((n,s)=>this.addChart(n,s===e.length-1)),this.update()}chartSize(t){let e=this.tabs[this.tab].curves.length,n=this.stack.clientHeight-21-e,s=Math.max(Math.floor(n/e),36);return{width:Math.max(this.stack.clientWidth-178,120),height:s+(t?20:0)}}resize(){this.charts.forEach(({plot:t},e)=>t.setSize(this.chartSize(e===this.charts.length-1))),this.update()}addChart(t,e){let n=L("span",{class:"readout"}),s=t.values===this.program.errorUm&&this.notCompared().length>0?[L("span",{class:"chart-limits"},`grey: ${tu}`)]:[],r=[...new Set(t.limits.map(M=>`${M.label} ${xe(M.value)}`))].slice(0,4).join(", "),o=L("div",{class:"chart"}),a=L("span",{class:"chart-name"},t.title),l=Vn(Ms(t.colour,this.theme));a.style.setProperty("--sample",l);let c=L("div",{class:"chart-row"},L("div",{class:"chart-head"},L("div",{class:"chart-title"},a,n),L("span",{class:"chart-limits",title:r},r),...s),o);this.stack.append(c);let[h,u]=this.zoom??this.whole(),d={stroke:ce("--grid"),width:1},f=ce("--muted"),m="11px system-ui, sans-serif",v=new Hn({...this.chartSize(e),legend:{show:!1},padding:[4,8,e?0:2,0],cursor:{y:!1,points:{show:!1},drag:{x:!0,y:!1,setScale:!1},bind:{dblclick:()=>()=>null}},scales:{x:{time:!1,min:h,max:u,auto:!1},y:{range:(M,b,C)=>this.yRange(t,b,C)}},axes:[{show:e,stroke:f,grid:d,ticks:{show:!1},font:m,size:20,gap:2,values:(M,b)=>b.map(C=>this.xText(C))},{stroke:f,grid:d,ticks:{show:!1},font:m,size:54,gap:4,space:15,values:(M,b)=>b.map(xe)}],series:[{},{stroke:l,width:1.25,pxAlign:0,points:{show:!1}}],hooks:{drawClear:[M=>{this.drawMarks(M),t.values===this.program.errorUm&&this.drawNotCompared(M)}],draw:[M=>this.drawLimits(M,t)],setCursor:[M=>this.cursorMoved(M)],setSelect:[M=>this.selected(M)]}},t.stepped?tT(this.xValues,t.values):[this.xValues,c_(t.values)],o),g=L("div",{class:"now"}),p=L("div",{class:"linked"});v.over.append(g,p),v.over.addEventListener("pointerleave",()=>this.hover.set(null));let y=0;v.over.addEventListener("pointerdown",M=>{y=M.clientX}),v.over.addEventListener("click",M=>{if(Math.abs(M.clientX-y)>4)return;let b=v.posToVal(M.offsetX,"x");this.timeline.pause(),this.x==="time"?this.timeline.seekTime(b):this.timeline.seek(this.pointAt(b))}),v.over.addEventListener("wheel",M=>{if(!M.ctrlKey&&!M.shiftKey)return;M.preventDefault();let[b,C]=this.zoom??this.whole(),A=v.posToVal(M.offsetX,"x"),_=Math.exp(Math.sign(M.deltaY||M.deltaX)*.25);this.setZoom([A-(A-b)*_,A+(C-A)*_])},{passive:!1}),this.charts.push({plot:v,curve:t,readout:n})}yRange(t,e,n){let[s,r]=[e??0,n??1];t.fromZero&&(s=Math.min(s,0));for(let a of t.limits){let l=a.value<=r+.35*(r-s)&&a.value>=s-.35*(r-s);(this.toLimits||l)&&([s,r]=[Math.min(s,a.value),Math.max(r,a.value)])}let o=r-s;return o<1e-9?[s-1,r+1]:[t.fromZero?s:s-.08*o,r+.1*o]}xText(t){if(this.x==="time")return ni(t).replace(/\.0$/,"");let e=Math.floor(t),{program:n}=this;return e!==t||e>=n.blocks||e<0?"":`line ${n.line[n.blockFirst[e]]}`}drawMarks(t){let{ctx:e,bbox:n}=t,{program:s}=this,r=c=>t.valToPos(c,"x",!0),[o,a]=[n.left,n.left+n.width];e.save(),e.beginPath(),e.rect(n.left,n.top,n.width,n.height),e.clip();let l=Number.NEGATIVE_INFINITY;for(let{kind:c,first:h,last:u}of s.stretches){let d=r(this.xValues[Math.max(h-1,0)]),f=r(this.xValues[u]);if(f<o||d>a)continue;if(e.fillStyle=J1(c),c==="inserted"){if(f<l+2)continue;l=f,e.fillRect(d,n.top+n.height-4*devicePixelRatio,Math.max(f-d,1),4*devicePixelRatio);continue}let m=Math.max(f-d,1.5*devicePixelRatio);e.globalAlpha=c==="rewind"?.45:.2,e.fillRect(d,n.top,m,n.height),e.globalAlpha=1,e.fillRect(d,n.top,m,3*devicePixelRatio)}e.fillStyle=ce(An.finding.colour);for(let c of s.head.findings)for(let{first:h,last:u}of s.findingStretches(c)){let d=r(this.xValues[Math.max(h-1,0)]),f=Math.max(r(this.xValues[u])-d,2*devicePixelRatio);d+f<o||d>a||(e.globalAlpha=.22,e.fillRect(d,n.top,f,n.height),e.globalAlpha=1,e.fillRect(d,n.top,2*devicePixelRatio,n.height),e.fillRect(d,n.top,f,3*devicePixelRatio))}e.restore()}notCompared(){let t=[];for(let e=0;e<this.program.count;e+=1){if(!this.program.isNotCompared(e))continue;let n=t.at(-1);n&&n.last===e-1?n.last=e:t.push({first:e,last:e})}return t}drawNotCompared(t){let{ctx:e,bbox:n}=t,[s,r]=[n.left,n.left+n.width],o=a=>Math.min(Math.max(t.valToPos(a,"x",!0),s),r);e.save(),e.font=`${11*devicePixelRatio}px system-ui, sans-serif`,e.textAlign="center",e.textBaseline="middle";for(let{first:a,last:l}of this.notCompared()){let c=o(this.xValues[Math.max(a-1,0)]),h=o(this.xValues[l])-c;h<=0||(e.fillStyle=ce("--grid"),e.fillRect(c,n.top,h,n.height),!(h<e.measureText(tu).width+8*devicePixelRatio)&&(e.fillStyle=ce("--muted"),e.fillText(tu,c+h/2,n.top+n.height/2)))}e.restore()}drawLimits(t,e){let{ctx:n,bbox:s}=t;n.save(),n.strokeStyle=ce("--limit"),n.lineWidth=1.25*devicePixelRatio,n.setLineDash([6*devicePixelRatio,4*devicePixelRatio]);for(let r of e.limits){let o=t.valToPos(r.value,"y",!0);if(o<s.top-1||o>s.top+s.height+1)continue;n.beginPath();let a=l=>Math.min(Math.max(t.valToPos(this.xValues[l],"x",!0),s.left),s.left+s.width);n.moveTo(r.first===0?s.left:a(r.first),o),n.lineTo(r.last===this.program.count-1?s.left+s.width:a(r.last),o),n.stroke()}n.restore()}cursorMoved(t){let{left:e}=t.cursor;this.linking||e===void 0||e<0||(this.linking=!0,this.hover.set(this.pointAt(t.posToVal(e,"x"))),this.linking=!1)}selected(t){let{left:e,width:n}=t.select;if(n<5)return;let s=[t.posToVal(e,"x"),t.posToVal(e+n,"x")];t.setSelect({left:0,top:0,width:0,height:0},!1),this.setZoom(s)}placeNow(t){l_(t,".now",this.xAt(this.timeline.position))}showHover(){let{point:t}=this.hover;for(let{plot:e}of this.charts)l_(e,".linked",t===null?null:this.xValues[t])}};function l_(i,t,e){let n=i.over.querySelector(t);if(!n)return;let s=e===null?-1:i.valToPos(e,"x");n.hidden=s<0||s>i.over.clientWidth,n.style.transform=`translateX(${s.toFixed(1)}px)`}var J1=i=>ce(An[i].colour);function Q1(i,t,e){return e<t.first||e>t.last?!1:t.label==="min"?i<t.value-1e-6:i>t.value+1e-6}function c_(i){return i.some(t=>Number.isNaN(t))?Array.from(i,t=>Number.isNaN(t)?null:t):i}function tT(i,t){let e=new Float64Array(2*i.length),n=new Float64Array(2*i.length);for(let s=0;s<i.length;s+=1)e[2*s]=i[Math.max(s-1,0)],e[2*s+1]=i[s],n[2*s]=n[2*s+1]=t[s];return[e,c_(n)]}function eT(i){let{joints:t}=i.head.machine,e=t.flatMap((a,l)=>a.held?[]:[{joint:a,i:l}]),n={first:0,last:i.count-1},s=i.placementRuns(),r=a=>s.flatMap(({placement:l,first:c,last:h})=>{let[u,d]=i.limits(a,l),f=u===null?[]:[{value:u,label:"min",first:c,last:h}];return d===null?f:[...f,{value:d,label:"max",first:c,last:h}]}),o={fromZero:!1,stepped:!1,decimals:3};return[{name:"axes",label:"Axis values",curves:e.map(({joint:a,i:l})=>({...o,title:a.letter,unit:Gi(a),values:i.axes[l],limits:r(l),colour:l}))},{name:"speeds",label:"Axis speeds",curves:e.map(({joint:a,i:l})=>({...o,title:a.letter,unit:`${Gi(a)}/min`,values:i.speeds[l],limits:a.speed===null?[]:[{value:a.speed,label:"max",...n}],stepped:!0,fromZero:!0,decimals:0,colour:l}))},{name:"feed",label:"Feed and error",curves:[{...o,title:"Feed",unit:"mm/min",values:i.feed,limits:[],stepped:!0,fromZero:!0,decimals:0,colour:0},{...o,title:"Path error",unit:"\xB5m",values:i.errorUm,limits:[{value:i.head.tolerance_mm*1e3,label:"tolerance",...n}],stepped:!0,fromZero:!0,decimals:2,colour:1}]}]}function Yo(i){let t=i.design_tolerance_mm+i.certified_mm;return{gouge:i.gouge_tolerance_mm+t,rest:i.rest_tolerance_mm+t}}var nT=27,iT=255,nu=6,Or=96;function Br(i,t){let e=i<0?nT:iT,n=Math.min(Math.abs(i),nu),s=t==="light"?.84:.72;if(n<=1)return to(s-.06*n,.012+.05*n,e);let r=(n-1)/(nu-1);return to(s-.2-.16*r,.15+.05*r,e)}var dl=i=>to(i==="light"?.8:.68,.035,95);function h_(i,t,e,n,s){let r=new Float32Array(3*t),o=s(dl(n)),a=Array.from({length:2*Or+1},(l,c)=>s(Br((c-Or)/Or*nu,n)));for(let l=0;l<t;l+=1){let c=i&&e?i[l]:Number.NaN,h=o;if(e&&Number.isFinite(c)){let u=Math.max(c<0?e.gouge:e.rest,1e-6),d=c/u/nu*Or;h=a[Or+Math.max(-Or,Math.min(Or,c<0?Math.floor(d):Math.ceil(d)))]}r.set(h,3*l)}return r}var sT=200,rT=12,oT={width:300,height:70},iu=class{constructor(t,e,n){this.simulation=t;this.events=e;let{figures:s}=t,{design:r,findings:o}=s,a=r?r.gouge_count+(r.exceeds_stock_mm>Yo(r).gouge?1:0):0,l=s.collisions===0&&a===0;this.root.append(L("h2",{},"Simulation"),L("p",{class:l?"good":"bad"},t.line)),r&&this.root.append(this.legend),this.addEntries(`Collisions (${s.collisions})`,o.map(c=>this.entry(u_(c.line,c.last_line,c.cl_line),c.text,{line:c.line,place:c.place_mm,onStock:!1})),s.collisions,"none"),r&&this.addDesign(r),s.clearances.length>0&&this.addClearances(),this.addRemoval(),this.addSentences("Tool table",s.tool_table),this.addSentences("Not checked",s.not_checked),this.addSentences("Assumed",s.assumed),this.root.append(L("p",{class:"note"},`Cut surfaces are within ${xe(s.tolerance_mm)} mm of the programmed motion; lines of the stock are ${xe(Math.max(...s.pitch_mm))} mm apart, nothing thinner is seen.`)),this.restyle(n)}simulation;events;root=L("section",{class:"panel",id:"simulation-panel","aria-label":"Simulation"});legend=L("div",{class:"legend"});jumps=[];current=-1;step(t){this.jumps.length!==0&&(this.current=this.current<0?t===1?0:this.jumps.length-1:(this.current+t+this.jumps.length)%this.jumps.length,this.jump(this.jumps[this.current]))}restyle(t){let{design:e}=this.simulation.figures;if(!e)return;let{gouge:n,rest:s}=Yo(e),r=[[Vn(Br(-6,t)),`gouge, ${xe(6*n)} mm and more`],[Vn(Br(-1.07,t)),`gouge, from ${xe(n)} mm`],[Vn(Br(0,t)),"on the design"],[Vn(Br(1.07,t)),`rest material, from ${xe(s)} mm`],[Vn(Br(6,t)),`rest material, ${xe(6*s)} mm and more`],[Vn(dl(t)),"not compared"]];ii(this.legend,L("ul",{},...r.map(([o,a])=>{let l=L("span",{class:"sample"});return l.style.setProperty("--sample",o),L("li",{},l,a)})))}jump(t){this.events.showPlace(t.line,t.place,t.onStock)}entry(t,e,n,s=!0){let r=s?L("span",{class:"mark mark-finding"}):"",o=L("button",{type:"button",class:"entry"},L("span",{class:"place"},r,t),L("span",{class:"text"},e)),a=this.jumps.length;return s&&this.jumps.push(n),o.addEventListener("click",()=>{s&&(this.current=a),this.jump(n)}),o}addEntries(t,e,n,s){if(this.root.append(L("h2",{},t)),e.length===0){this.root.append(L("p",{class:"good"},s));return}let r=e.slice(0,sT);this.root.append(L("ol",{class:"entries"},...r.map(o=>L("li",{},o)))),n>r.length&&this.root.append(L("p",{class:"note"},`and ${n-r.length} more`))}addDesign(t){let e=r=>this.entry(r.line===null?r.blank?"as the blank":"line unknown":u_(r.line,r.line,r.cl_line??0),r.text,{line:r.line,place:r.place_mm,onStock:!0}),{gouge:n,rest:s}=Yo(t);t.exceeds_stock_mm>n&&this.root.append(L("p",{class:"bad"},`The design exceeds the box of the stock by ${He(t.exceeds_stock_mm,3)} mm and is not compared there.`)),this.addEntries(`Gouges (${t.gouge_count})`,t.gouges.map(e),t.gouge_count,`none: the largest is ${He(t.largest_gouge_mm,3)} mm, allowed are ${He(n,3)} mm`),this.addEntries(`Rest material (${t.rest_count})`,t.rests.map(e),t.rest_count,`none: the largest is ${He(t.largest_rest_mm,3)} mm, allowed are ${He(s,3)} mm`),this.root.append(L("h2",{},"Distance from the design"),aT(t))}addClearances(){let{clearances:t}=this.simulation.figures;this.addEntries("Smallest clearances",t.slice(0,rT).map(e=>this.entry(`${He(e.distance_mm,2)} mm`,`${e.bodies[0]} and ${e.bodies[1]}, line ${e.line}, tool ${e.tool}`,{line:e.line,place:e.place_mm,onStock:!1},!1)),t.length,"none")}addRemoval(){let{operations:t,removed_mm3:e,engagement:n}=this.simulation.figures,s=t.map(l=>L("tr",{},L("td",{},`${l.operation}`),L("td",{},`T${l.tool}`),L("td",{},xe(l.removed_mm3/1e3)),L("td",{},l.cutting_min>0?ni(60*l.cutting_min):"\u2013"),L("td",{},l.largest_mm3_per_min===null?"\u2013":xe(l.largest_mm3_per_min/1e3)))),r=["operation","tool","cm\xB3","in material","most cm\xB3/min"];this.root.append(L("h2",{},`Removed: ${xe(e/1e3)} cm\xB3`),L("table",{class:"figures"},L("thead",{},L("tr",{},...r.map(l=>L("th",{},l)))),L("tbody",{},...s)));let{removed_mm3:o,step_min:a}=n;o.length>1&&this.root.append(lT(o.map(l=>l/a/1e3),a*o.length))}addSentences(t,e){e.length!==0&&this.root.append(L("h2",{},t),L("ul",{class:"warnings"},...e.map(n=>L("li",{},n))))}},u_=(i,t,e)=>`${t>i?`lines ${i} to ${t}`:`line ${i}`}, CL line ${e}`;function aT(i){let t=i.histogram.reduce((r,o)=>r+o.ends,0)||1,e=Math.max(...i.histogram.map(r=>r.ends),1),n=(r,o)=>r===null?`below ${xe(o??0)}`:o===null?`above ${xe(r)}`:`${xe(r)} to ${xe(o)}`,s=i.histogram.filter(r=>r.ends>0).map(r=>{let o=L("span",{class:(r.to_mm??1)<=0?"bar inside":"bar"});return o.style.width=`${(100*r.ends/e).toFixed(1)}%`,L("tr",{},L("td",{},n(r.from_mm,r.to_mm)),L("td",{},`${(100*r.ends/t).toFixed(2)} %`),L("td",{class:"bars"},o))});return L("table",{class:"figures histogram"},L("thead",{},L("tr",{},L("th",{},"mm (below 0: inside)"),L("th",{},"share"),L("th",{}))),L("tbody",{},...s))}function lT(i,t){let e="http://www.w3.org/2000/svg",n=Math.max(...i,1e-9),{width:s,height:r}=oT,o=document.createElementNS(e,"svg");o.setAttribute("viewBox",`0 0 ${s} ${r}`),o.setAttribute("class","removal-chart"),o.setAttribute("role","img"),o.setAttribute("aria-label",`Rate of removal over ${xe(t)} min at feed, at most ${xe(n)} cm\xB3/min`);let a=document.createElementNS(e,"path"),l=i.map((h,u)=>{let d=(r-h/n*(r-2)).toFixed(1);return`L${(u/i.length*s).toFixed(1)} ${d}L${((u+1)/i.length*s).toFixed(1)} ${d}`});a.setAttribute("d",`M0 ${r}${l.join("")}L${s} ${r}Z`),o.append(a);let c=L("figure",{class:"removal"});return c.append(o,L("figcaption",{},`Rate of removal over ${ni(60*t)} at feed; the top is ${xe(n)} cm\xB3/min.`)),c}var su=class{constructor(t,e,n,s){this.program=t;this.timeline=e;this.stage=n;this.clPoints=s;let{joints:r,frame_after:o}=t.head.machine;this.rows=r.map((a,l)=>this.row(l,l<o?"table":"head",a.held)),this.root.append(L("h2",{},"axis values (from the zero position)"),L("div",{class:"axes"},...this.rows.map(a=>a.row)),L("dl",{class:"facts"},L("dt",{},"tip on the part"),this.tip,L("dt",{},"Tool axis"),this.axis,L("dt",{},"Feed"),this.feed,L("dt",{},"Tool"),this.tool),this.cl),this.cl.hidden=!s.comparable,ii(this.cl,...["CL point","difference","CL tool axis","difference"].flatMap(a=>[L("dt",{},a),L("dd",{},"\u2013")]))}program;timeline;stage;clPoints;root=L("section",{class:"panel position","aria-label":"Position"});rows;placement=-1;tip=L("dd");axis=L("dd");cl=L("dl",{class:"facts cl-point"});feed=L("dd");tool=L("dd");update(){let{program:t,timeline:e}=this,n=t.axesBetween(e.position),s=t.placement[Math.floor(e.position)];t.head.machine.joints.forEach((a,l)=>{let{value:c,bar:h,row:u,limits:d}=this.rows[l],[f,m]=t.limits(l,s);if(s!==this.placement&&(d.textContent=a.held?"held":cT(f,m,a.min!==null||a.max!==null),h.parentElement?.toggleAttribute("hidden",f===null||m===null)),c.textContent=He(n[l],3),u.classList.toggle("outside",f!==null&&n[l]<f-1e-6||m!==null&&n[l]>m+1e-6),f!==null&&m!==null){let v=(n[l]-f)/(m-f||1);h.style.left=`${(100*Math.min(Math.max(v,0),1)).toFixed(2)}%`}}),this.placement=s;let r=e.point;this.tip.textContent=this.stage.machine.drawnTip().map(a=>He(a,3)).join("  "),this.axis.textContent=this.stage.machine.drawnToolAxis().map(a=>He(a,4)).join("  "),this.showClPoint(),this.feed.textContent=t.isStart(r)?"\u2013":t.isRapid(r)?"rapid":`${xe(t.feed[r])} mm/min`;let o=t.toolAt(Math.floor(e.position));this.tool.textContent=Sl(o)}showClPoint(){let{point:t,position:e}=this.timeline,n=e===t?this.clPoints.at(t):null;if(this.cl.style.visibility=n===null?"hidden":"visible",n===null)return;let{machine:s}=this.stage,r=this.program.head.tolerance_mm,o=wn(tn(s.drawnTip(),n.tip)),a=[["CL point",L("dd",{},n.tip.map(l=>He(l,3)).join("  "))],["difference",L("dd",o>r?{class:"bad"}:{},`${He(o,4)} mm of ${xe(r)}`)]];if(n.axis!==null){let l=s.drawnToolAxis(),c=Math.atan2(wn(ci(l,n.axis)),un(l,n.axis))*180/Math.PI;a.push(["CL tool axis",L("dd",{},n.axis.map(h=>He(h,4)).join("  "))],["difference",L("dd",{},`${He(c,4)}\xB0`)])}ii(this.cl,...a.flatMap(([l,c])=>[L("dt",{},l),c]))}row(t,e,n){let s=this.program.head.machine.joints[t],r=L("span",{class:"value"}),o=L("span",{class:"needle"}),a=L("span",{class:"limits"}),l=L("div",{class:`axis ${e}${n?" held":""}`},L("span",{class:"letter"},s.letter),r,L("span",{class:"unit"},Gi(s)),L("span",{class:"travel"},L("span",{class:"track"},o),a));return{value:r,bar:o,row:l,limits:a}}};function cT(i,t,e){return i===null&&t===null?e?"limits unknown: no machine zero":"no limits":`${i===null?"":xe(i)} \u2026 ${t===null?"":xe(t)}`}var fl=class{constructor(t){this.text=t;for(let e=t.indexOf(`
`);e>=0;e=t.indexOf(`
`,e+1))this.starts.push(e+1);this.starts.length>1&&this.starts.at(-1)===t.length&&this.starts.pop()}text;starts=[0];get count(){return this.starts.length}get longest(){return this.starts.reduce((t,e,n)=>Math.max(t,(this.starts[n+1]??this.text.length)-e),0)}line(t){if(t<1||t>this.count)return"";let e=t<this.count?this.starts[t]:this.text.length;return this.text.slice(this.starts[t-1],e).replace(/[\r\n]+$/,"")}lineOfOffset(t){let e=0,n=this.starts.length-1;for(;e<n;){let s=e+n+1>>>1;this.starts[s]<=t?e=s:n=s-1}return e+1}search(t){let e=[];if(t==="")return e;let n=this.text.toLowerCase(),s=t.toLowerCase();if(n.length!==this.text.length){for(let r=1;r<=this.count;r+=1)this.line(r).toLowerCase().includes(s)&&e.push(r);return e}for(let r=n.indexOf(s);r>=0;){let o=this.lineOfOffset(r);if(e.push(o),o>=this.count)break;r=n.indexOf(s,this.starts[o])}return e}},hT=["linuxcnc","fanuc","haas"];function d_(i,t){let e=[],n=hT.includes(t)?/(\([^)]*\)?|;.*$)|(^\s*\/?\s*N\d+)|(\b[GM]\d+(?:\.\d+)?)|([^(;GM]+|.)/gi:/(;.*$)|(^\s*\/?\s*(?:N\d+|\d+(?=\s)))|(\b[GM]\d+(?:\.\d+)?)|([^;GM]+|.)/gi;for(let s of i.matchAll(n)){let r=s[1]?"comment":s[2]?"number":s[3]?"code":"word",o=e.at(-1);o&&o.kind===r&&r==="word"?o.text+=s[0]:e.push({text:s[0],kind:r})}return e}var Hs=20,uT=8e6,ru=class{constructor(t,e,n){this.lines=t;this.events=n;this.control=e.head.control,this.findings=e.head.findings,this.digits=String(t.count).length,this.collectMarks(e),this.spacer.style.height=`${this.heightPx}px`,this.spacer.style.minWidth=`calc(${t.longest+this.digits}ch + 50px)`,this.spacer.append(this.rows),this.scroller.append(this.spacer);let s=L("button",{type:"button",class:"small","aria-label":"Previous match",title:"Previous match (Shift+Enter)"},"\u2191"),r=L("button",{type:"button",class:"small","aria-label":"Next match",title:"Next match (Enter)"},"\u2193");s.addEventListener("click",()=>this.nextMatch(-1)),r.addEventListener("click",()=>this.nextMatch(1));let o=L("h2",{},e.head.program);o.title=e.head.program,this.root.append(L("header",{},o,L("div",{class:"search"},this.searchField,this.found,s,r)),L("div",{class:"text-body"},this.scroller,this.ruler)),this.listen(),new ResizeObserver(()=>{this.render(),this.drawRuler()}).observe(this.scroller)}lines;events;root=L("section",{class:"text-pane","aria-label":"Program text"});searchField=L("input",{type:"search",id:"search",placeholder:"Search (/)","aria-label":"Search the program",autocomplete:"off",spellcheck:"false"});found=L("span",{class:"found",role:"status"});scroller=L("div",{id:"program",class:"program",tabindex:"0",role:"listbox","aria-label":"Lines of the program"});spacer=L("div",{class:"spacer"});rows=L("div",{class:"rows",role:"presentation"});ruler=L("canvas",{class:"ruler","aria-hidden":"true"});marks=new Map;findings;insertedTexts=new Map;digits;control;matches=[];current=0;hovered=0;rowsShown="";setCurrent(t,e=!0){t!==this.current&&(this.current=t,e&&this.reveal(t),this.render(),this.drawRuler())}get currentLine(){return this.current}setHover(t){(t??0)!==this.hovered&&(this.hovered=t??0,this.render())}restyle(){this.drawRuler()}nextMatch(t){if(this.matches.length===0)return;let n=(Es(this.matches,t===1?this.current+1:this.current)+(t===1?0:-1)+this.matches.length)%this.matches.length;this.found.textContent=`${n+1} / ${this.matches.length}`;let s=this.matches[n];this.events.select(s),this.reveal(s),this.current=s,this.render(),this.drawRuler()}get heightPx(){return Math.min(this.lines.count*Hs,uT)}get topLine(){let t=this.heightPx-this.scroller.clientHeight;if(this.heightPx===this.lines.count*Hs||t<=0)return this.scroller.scrollTop/Hs;let e=this.lines.count-this.scroller.clientHeight/Hs;return this.scroller.scrollTop/t*e}reveal(t){let e=this.scroller.clientHeight/Hs,n=this.topLine;if(t-1>=n+2&&t<=n+e-3)return;let s=Math.min(Math.max(t-1-e*.4,0),Math.max(this.lines.count-e,0)),r=this.heightPx===this.lines.count*Hs,o=Math.max(this.lines.count-e,1e-9);this.scroller.scrollTop=r?s*Hs:s/o*(this.heightPx-this.scroller.clientHeight)}render(){let t=this.topLine,e=Math.max(1,Math.floor(t)-5),n=Math.min(this.lines.count,Math.ceil(t+this.scroller.clientHeight/Hs)+5),s=`${e} ${n} ${this.current} ${this.hovered} ${this.searchField.value} ${t===Math.floor(t)?"":t.toFixed(2)}`;if(s===this.rowsShown)return;this.rowsShown=s;let r=this.scroller.scrollTop-(t-(e-1))*Hs;this.rows.style.transform=`translateY(${r.toFixed(1)}px)`;let o=[];for(let a=e;a<=n;a+=1)o.push(this.row(a));this.rows.replaceChildren(...o),this.scroller.setAttribute("aria-activedescendant",`line-${this.current}`)}row(t){let e=L("div",{class:"line",role:"option",id:`line-${t}`,"data-line":t,"aria-selected":String(t===this.current)});t===this.current&&e.setAttribute("aria-current","true"),t===this.hovered&&e.classList.add("hovered");let n=L("span",{class:"gutter"});for(let c of this.marks.get(t)??[])n.append(L("span",{class:`mark mark-${c}`,title:c==="inserted"?this.insertedTexts.get(t)??An.inserted.label:An[c].label}));let s=L("span",{class:"line-number"},String(t).padStart(this.digits)),r=L("span",{class:"code"}),o=this.lines.line(t),a=this.searchField.value;for(let c of d_(o,this.control))r.append(c.kind==="word"?f_(c.text,a):L("span",{class:`token-${c.kind}`},f_(c.text,a)));let l=this.findings.filter(c=>t>=c.line&&t<=c.last_line);return l.length>0&&(e.title=l.map(c=>c.text).join(`
`),e.classList.add("has-finding"),l.some(c=>c.line===t)&&n.prepend(L("span",{class:"mark mark-finding",title:An.finding.label}))),e.append(n,s,r),e}collectMarks(t){let e=(n,s)=>{let r=this.marks.get(n)??new Set;r.add(s),this.marks.set(n,r)};for(let{kind:n,first:s,last:r}of t.stretches)for(let o=t.block[s];o<=t.block[r];o+=1){let a=t.line[t.blockFirst[o]];e(a,n),n==="inserted"&&this.insertedTexts.set(a,`inserted block: ${t.reasonText(t.blockFirst[o])??"reason unknown"}`)}}drawRuler(){let{clientWidth:t,clientHeight:e}=this.ruler;if(t===0||e===0)return;let n=devicePixelRatio;this.ruler.width=t*n,this.ruler.height=e*n;let s=this.ruler.getContext("2d");if(!s)return;s.scale(n,n);let r=a=>(a-.5)/this.lines.count*e,o=["pole","retract","rewind"];for(let a of o){s.fillStyle=ce(An[a].colour);for(let[l,c]of this.marks)c.has(a)&&s.fillRect(2,r(l)-1,t,2)}s.fillStyle=ce(An.finding.colour);for(let{line:a,last_line:l}of this.findings){let c=r(a-.5);s.fillRect(0,c,t,Math.max(r(l+.5)-c,4))}s.fillStyle=ce("--accent"),s.fillRect(0,r(this.current)-1,t,2.5)}listen(){let t=n=>{let s=n.target.closest("[data-line]");return s?Number(s.dataset.line):null};this.scroller.addEventListener("scroll",()=>this.render(),{passive:!0}),this.scroller.addEventListener("click",n=>{let s=t(n);s!==null&&getSelection()?.isCollapsed!==!1&&this.events.select(s)}),this.scroller.addEventListener("pointerover",n=>this.events.hover(t(n))),this.scroller.addEventListener("pointerleave",()=>this.events.hover(null)),this.scroller.addEventListener("keydown",n=>{let s={ArrowDown:1,ArrowUp:-1}[n.key];if(s===void 0||n.ctrlKey||n.metaKey||n.altKey)return;n.preventDefault(),n.stopPropagation();let r=Math.min(Math.max(this.current+s,1),this.lines.count);this.events.select(r),this.current=r,this.reveal(r),this.render(),this.drawRuler()}),this.ruler.addEventListener("click",n=>{this.events.select(Math.max(1,Math.ceil(n.offsetY/this.ruler.clientHeight*this.lines.count)))});let e=0;this.searchField.addEventListener("input",()=>{clearTimeout(e),e=window.setTimeout(()=>this.search(),150)}),this.searchField.addEventListener("keydown",n=>{n.key==="Enter"?(n.preventDefault(),clearTimeout(e),this.search(),this.nextMatch(n.shiftKey?-1:1)):n.key==="Escape"&&(this.searchField.value="",this.search(),this.scroller.focus())})}search(){let t=this.searchField.value,e=/^:(\d+)$/.exec(t);this.matches=e?[Math.min(Math.max(Number(e[1]),1),this.lines.count)]:this.lines.search(t),this.found.textContent=t===""?"":this.matches.length===0?"none":String(this.matches.length),this.render()}};function f_(i,t){let e=document.createDocumentFragment(),n=t.toLowerCase(),s=i.toLowerCase(),r=0;if(n!==""&&s.length===i.length)for(let o=s.indexOf(n);o>=0;o=s.indexOf(n,r))e.append(i.slice(r,o),L("mark",{},i.slice(o,o+n.length))),r=o+n.length;return e.append(i.slice(r)),e}var mr=[.1,.25,.5,1,2,5,10,20,50,100,200,500,1e3],dT=60,ou=class{constructor(t){this.program=t;let e=t.totalS/dT;this.pace=mr.find(n=>n>=e)??mr[mr.length-1],this.pace<1&&(this.pace=1)}program;position=0;playing=!1;pace;lastFrameMs=0;listeners=[];calm=matchMedia("(prefers-reduced-motion: reduce)");playedS=0;get point(){return Ts.pointAt(this.position)}get timeS(){return this.program.timeAt(this.position)}onChange(t){this.listeners.push(t)}seek(t){let e=Math.max(this.program.count-1,0);this.position=Math.min(Math.max(t,0),e),Number.isFinite(this.position)||(this.position=0),this.changed()}seekTime(t){this.seek(this.program.positionAt(t))}play(){this.playing||this.program.count<2||(this.position>=this.program.count-1&&(this.position=0),this.playing=!0,this.playedS=this.timeS,this.lastFrameMs=performance.now(),requestAnimationFrame(t=>this.frame(t)),this.changed())}pause(){this.playing&&(this.playing=!1,this.changed())}toggle(){this.playing?this.pause():this.play()}stepBlock(t){this.pause();let{program:e}=this,n=e.block[this.point],s=this.position>=e.blockLast(n),r=t===1?s?n+1:n:n-1;this.seek(e.blockLast(Math.min(Math.max(r,0),e.blocks-1)))}stepPoint(t){this.pause(),this.seek(t===1?Math.floor(this.position)+1:Math.ceil(this.position)-1)}stepOperation(t){this.pause();let e=this.program.head.operations.filter(s=>s.points>0).map(s=>s.first_point),n=t===1?e.find(s=>s>this.position):e.findLast(s=>s<this.position);n!==void 0?this.seek(n):this.seek(t===1?this.program.count-1:0)}stepPace(t){let e=mr.indexOf(this.pace)+t;e>=0&&e<mr.length&&this.setPace(mr[e])}setPace(t){this.pace=t,this.changed()}frame(t){if(!this.playing)return;let e=Math.min(Math.max(t-this.lastFrameMs,0),500)/1e3;this.lastFrameMs=t;let{program:n}=this;if(Math.abs(n.timeAt(this.position)-this.playedS)>1e-6&&!this.calm.matches&&(this.playedS=this.timeS),this.playedS+=e*this.pace,this.playedS>=n.totalS){this.playing=!1,this.seek(n.count-1);return}let s=n.positionAt(this.playedS);if(this.calm.matches){let r=n.block[Math.floor(s)];this.position=n.blockFirst[r]>0?n.blockFirst[r]-1:0}else this.position=s;this.changed(),requestAnimationFrame(r=>this.frame(r))}changed(){for(let t of this.listeners)t()}};var kr={play:"M6 4.5v11l9-5.5z",pause:"M6 4.5h2.5v11H6zM11.5 4.5H14v11h-2.5z",next:"M5 5v10l6-5zM13.5 5v10",previous:"M15 5v10l-6-5zM6.5 5v10",start:"M15.5 5v10l-5-5zM9.5 5v10l-5-5zM3.5 5v10",end:"M4.5 5v10l5-5zM10.5 5v10l5-5zM16.5 5v10"},au=class{constructor(t,e,n){this.program=t;this.timeline=e;this.theme=n;let s=(o,a,l,c)=>dn({label:o,icon:ls(a),key:l,press:c});this.playButton=s("Play",kr.play,"Space",()=>e.toggle()),this.playButton.id="play",this.playButton.classList.add("primary");let r=t.totalS;this.scrub.max=String(r>0?r:1);for(let o of mr)this.pace.append(L("option",{value:String(o)},`${o}\xD7`));this.root.append(L("div",{class:"buttons",role:"group","aria-label":"Steps"},s("First point",kr.start,"Home",()=>e.seek(0)),s("Previous block",kr.previous,"\u2190",()=>e.stepBlock(-1)),this.playButton,s("Next block",kr.next,"\u2192",()=>e.stepBlock(1)),s("Last point",kr.end,"End",()=>e.seek(t.count-1))),this.pace,L("div",{class:"scrubber"},this.strip,this.scrub),this.time),this.scrub.addEventListener("input",()=>{let o=Number(this.scrub.value);e.pause(),e.seekTime(o)}),this.pace.addEventListener("change",()=>e.setPace(Number(this.pace.value))),e.onChange(()=>this.update()),new ResizeObserver(()=>this.drawStrip()).observe(this.strip),t.hasUnknownTimes&&(this.time.title="Rapids of axes without a configured speed are played at 10 m/min and 3600 \xB0/min, and not counted"),this.update()}program;timeline;theme;root=L("section",{class:"transport","aria-label":"Playback"});playButton;scrub=L("input",{type:"range",id:"scrub",min:"0",step:"any","aria-label":"Machining time"});pace=L("select",{id:"pace","aria-label":"Speed of playback",title:"Speed of playback (+ and \u2212)"});time=L("output",{class:"time"});strip=L("canvas",{class:"strip","aria-hidden":"true"});restyle(t){this.theme=t,this.drawStrip()}update(){let{timeline:t,program:e}=this,n=t.timeS;this.scrub.value=String(n);let{counted:s,total:r}={counted:e.countedS[t.point],total:e.countedS[e.count-1]};this.time.textContent=`${ni(s)} / ${ni(r)}`,this.scrub.setAttribute("aria-valuetext",`${ni(s)} of ${ni(r)}, line ${e.line[t.point]}`),this.pace.value=String(t.pace);let o=t.playing?"Pause":"Play";this.playButton.getAttribute("aria-label")!==o&&(this.playButton.setAttribute("aria-label",o),this.playButton.title=`${o} (Space)`,this.playButton.replaceChildren(ls(t.playing?kr.pause:kr.play)))}drawStrip(){let{clientWidth:t,clientHeight:e}=this.strip;if(t===0)return;let n=devicePixelRatio;this.strip.width=t*n,this.strip.height=e*n;let s=this.strip.getContext("2d");if(!s)return;s.scale(n,n);let{program:r}=this,o=a=>r.timeS[Math.min(Math.max(a,0),r.count-1)]/(r.totalS||1)*t;r.head.operations.forEach((a,l)=>{if(a.points===0)return;let c=o(a.first_point-1),h=o(a.first_point+a.points-1);s.fillStyle=Vn(Ms(l,this.theme)),s.fillRect(c,e-4,Math.max(h-c-1,1),4)});for(let a of["pole","retract","rewind"]){s.fillStyle=ce(An[a].colour);for(let l of df(r,a))s.fillRect(o(l)-1,2,2,e-7)}s.fillStyle=ce(An.finding.colour);for(let a of r.head.findings)for(let{first:l,last:c}of r.findingStretches(a)){let h=o(l-1),u=Math.max(o(c)-h,3);s.fillRect(Math.min(h,t-u),0,u,e-5)}}};var lu=class{point=null;listeners=[];set(t){if(t!==this.point){this.point=t;for(let e of this.listeners)e()}}onChange(t){this.listeners.push(t)}};Pt.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Xt},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};ai.line={uniforms:ja.merge([Pt.common,Pt.fog,Pt.line]),vertexShader:`
		#include <common>
		#include <color_pars_vertex>
		#include <fog_pars_vertex>
		#include <logdepthbuf_pars_vertex>
		#include <clipping_planes_pars_vertex>

		uniform float linewidth;
		uniform vec2 resolution;

		attribute vec3 instanceStart;
		attribute vec3 instanceEnd;

		attribute vec3 instanceColorStart;
		attribute vec3 instanceColorEnd;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#ifdef USE_DASH

			uniform float dashScale;
			attribute float instanceDistanceStart;
			attribute float instanceDistanceEnd;
			varying float vLineDistance;

		#endif

		float trimSegmentAlpha( const in vec4 start, const in vec4 end ) {

			// compute the interpolation factor needed to trim the segment so it terminates
			// between the camera plane and the near plane

			// conservative estimate of the near plane
			float a = projectionMatrix[ 2 ][ 2 ]; // 3nd entry in 3th column
			float b = projectionMatrix[ 3 ][ 2 ]; // 3nd entry in 4th column

			// we need different nearEstimate formula for reversed and default depth buffer
			// a is positive with a reversed depth buffer so it can be used for controlling the code flow
			float nearEstimate = ( a > 0.0 ) ? ( - b / ( a + 1.0 ) ) : ( - 0.5 * b / a );

			return ( nearEstimate - start.z ) / ( end.z - start.z );

		}

		void main() {

			#ifdef USE_COLOR

				vColor.xyz = ( position.y < 0.5 ) ? instanceColorStart : instanceColorEnd;

			#endif

			float aspect = resolution.x / resolution.y;

			// camera space
			vec4 start = modelViewMatrix * vec4( instanceStart, 1.0 );
			vec4 end = modelViewMatrix * vec4( instanceEnd, 1.0 );

			#ifdef USE_DASH

				float lineDistanceStart = dashScale * instanceDistanceStart;
				float lineDistanceEnd = dashScale * instanceDistanceEnd;

			#endif

			#ifdef WORLD_UNITS

				worldStart = start.xyz;
				worldEnd = end.xyz;

			#else

				vUv = uv;

			#endif

			// special case for perspective projection, and segments that terminate either in, or behind, the camera plane
			// clearly the gpu firmware has a way of addressing this issue when projecting into ndc space
			// but we need to perform ndc-space calculations in the shader, so we must address this issue directly
			// perhaps there is a more elegant solution -- WestLangley

			bool perspective = ( projectionMatrix[ 2 ][ 3 ] == - 1.0 ); // 4th entry in the 3rd column

			if ( perspective ) {

				if ( start.z < 0.0 && end.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( start, end );
					end.xyz = mix( start.xyz, end.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceEnd = mix( lineDistanceStart, lineDistanceEnd, alpha );

					#endif

				} else if ( end.z < 0.0 && start.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( end, start );
					start.xyz = mix( end.xyz, start.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceStart = mix( lineDistanceEnd, lineDistanceStart, alpha );

					#endif

				}

			}

			#ifdef USE_DASH

				vLineDistance = ( position.y < 0.5 ) ? lineDistanceStart : lineDistanceEnd;
				vUv = uv;

			#endif

			// clip space
			vec4 clipStart = projectionMatrix * start;
			vec4 clipEnd = projectionMatrix * end;

			// ndc space
			vec3 ndcStart = clipStart.xyz / clipStart.w;
			vec3 ndcEnd = clipEnd.xyz / clipEnd.w;

			// direction
			vec2 dir = ndcEnd.xy - ndcStart.xy;

			// account for clip-space aspect ratio
			dir.x *= aspect;
			dir = normalize( dir );

			#ifdef WORLD_UNITS

				vec3 worldDir = normalize( end.xyz - start.xyz );
				vec3 tmpFwd = perspective ? normalize( mix( start.xyz, end.xyz, 0.5 ) ) : vec3( 0.0, 0.0, - 1.0 );
				vec3 worldUp = normalize( cross( worldDir, tmpFwd ) );
				vec3 worldFwd = cross( worldDir, worldUp );
				worldPos = position.y < 0.5 ? start: end;

				// height offset
				float hw = linewidth * 0.5;
				worldPos.xyz += position.x < 0.0 ? hw * worldUp : - hw * worldUp;

				// don't extend the line if we're rendering dashes because we
				// won't be rendering the endcaps
				#ifndef USE_DASH

					// cap extension
					worldPos.xyz += position.y < 0.5 ? - hw * worldDir : hw * worldDir;

					// add width to the box
					worldPos.xyz += worldFwd * hw;

					// endcaps
					if ( position.y > 1.0 || position.y < 0.0 ) {

						worldPos.xyz -= worldFwd * 2.0 * hw;

					}

				#endif

				// project the worldpos
				vec4 clip = projectionMatrix * worldPos;

				// shift the depth of the projected points so the line
				// segments overlap neatly
				vec3 clipPose = ( position.y < 0.5 ) ? ndcStart : ndcEnd;

				// only shift the depth of vertices in front of the camera (#35137)
				if ( clip.w > 0.0 ) clip.z = clipPose.z * clip.w;

			#else

				vec2 offset = vec2( dir.y, - dir.x );
				// undo aspect ratio adjustment
				dir.x /= aspect;
				offset.x /= aspect;

				// sign flip
				if ( position.x < 0.0 ) offset *= - 1.0;

				// endcaps
				if ( position.y < 0.0 ) {

					offset += - dir;

				} else if ( position.y > 1.0 ) {

					offset += dir;

				}

				// adjust for linewidth
				offset *= linewidth;

				// adjust for clip-space to screen-space conversion // maybe resolution should be based on viewport ...
				offset /= resolution.y;

				// select end
				vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;

				// back to clip space
				offset *= clip.w;

				clip.xy += offset;

			#endif

			gl_Position = clip;

			vec4 mvPosition = ( position.y < 0.5 ) ? start : end; // this is an approximation

			#include <logdepthbuf_vertex>
			#include <clipping_planes_vertex>
			#include <fog_vertex>

		}
		`,fragmentShader:`
		uniform vec3 diffuse;
		uniform float opacity;
		uniform float linewidth;

		#ifdef USE_DASH

			uniform float dashOffset;
			uniform float dashSize;
			uniform float gapSize;

		#endif

		varying float vLineDistance;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#include <common>
		#include <color_pars_fragment>
		#include <fog_pars_fragment>
		#include <logdepthbuf_pars_fragment>
		#include <clipping_planes_pars_fragment>

		vec2 closestLineToLine(vec3 p1, vec3 p2, vec3 p3, vec3 p4) {

			float mua;
			float mub;

			vec3 p13 = p1 - p3;
			vec3 p43 = p4 - p3;

			vec3 p21 = p2 - p1;

			float d1343 = dot( p13, p43 );
			float d4321 = dot( p43, p21 );
			float d1321 = dot( p13, p21 );
			float d4343 = dot( p43, p43 );
			float d2121 = dot( p21, p21 );

			float denom = d2121 * d4343 - d4321 * d4321;

			float numer = d1343 * d4321 - d1321 * d4343;

			mua = numer / denom;
			mua = clamp( mua, 0.0, 1.0 );
			mub = ( d1343 + d4321 * ( mua ) ) / d4343;
			mub = clamp( mub, 0.0, 1.0 );

			return vec2( mua, mub );

		}

		void main() {

			float alpha = opacity;
			vec4 diffuseColor = vec4( diffuse, alpha );

			#include <clipping_planes_fragment>

			#ifdef USE_DASH

				if ( vUv.y < - 1.0 || vUv.y > 1.0 ) discard; // discard endcaps

				if ( mod( vLineDistance + dashOffset, dashSize + gapSize ) > dashSize ) discard; // todo - FIX

			#endif

			#ifdef WORLD_UNITS

				float len;

				if ( isOrthographic ) {

					// View rays are parallel to the z axis so the distance reduces to camera-space XY
					vec2 lineDir = worldEnd.xy - worldStart.xy;
					float t = clamp( dot( worldPos.xy - worldStart.xy, lineDir ) / dot( lineDir, lineDir ), 0.0, 1.0 );
					len = length( worldStart.xy + lineDir * t - worldPos.xy );

				} else {

					// Find the closest points on the view ray and the line segment
					vec3 rayEnd = normalize( worldPos.xyz ) * 1e5;
					vec3 lineDir = worldEnd - worldStart;
					vec2 params = closestLineToLine( worldStart, worldEnd, vec3( 0.0, 0.0, 0.0 ), rayEnd );

					vec3 p1 = worldStart + lineDir * params.x;
					vec3 p2 = rayEnd * params.y;
					vec3 delta = p1 - p2;
					len = length( delta );

				}

				float norm = len / linewidth;

				#ifndef USE_DASH

					#ifdef USE_ALPHA_TO_COVERAGE

						float dnorm = fwidth( norm );
						alpha = 1.0 - smoothstep( 0.5 - dnorm, 0.5 + dnorm, norm );

					#else

						if ( norm > 0.5 ) {

							discard;

						}

					#endif

				#endif

			#else

				#ifdef USE_ALPHA_TO_COVERAGE

					// artifacts appear on some hardware if a derivative is taken within a conditional
					float a = vUv.x;
					float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
					float len2 = a * a + b * b;
					float dlen = fwidth( len2 );

					if ( abs( vUv.y ) > 1.0 ) {

						alpha = 1.0 - smoothstep( 1.0 - dlen, 1.0 + dlen, len2 );

					}

				#else

					if ( abs( vUv.y ) > 1.0 ) {

						float a = vUv.x;
						float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
						float len2 = a * a + b * b;

						if ( len2 > 1.0 ) discard;

					}

				#endif

			#endif

			#include <logdepthbuf_fragment>
			#include <color_fragment>

			gl_FragColor = vec4( diffuseColor.rgb, alpha );

			#include <tonemapping_fragment>
			#include <colorspace_fragment>
			#include <fog_fragment>
			#include <premultiplied_alpha_fragment>

		}
		`};var Zo=class extends kn{constructor(t){super({type:"LineMaterial",uniforms:ja.clone(ai.line.uniforms),vertexShader:ai.line.vertexShader,fragmentShader:ai.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(t)}get color(){return this.uniforms.diffuse.value}set color(t){this.uniforms.diffuse.value=t}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(t){t===!0!==this.worldUnits&&(this.needsUpdate=!0),t===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(t){this.uniforms.linewidth&&(this.uniforms.linewidth.value=t)}get dashed(){return"USE_DASH"in this.defines}set dashed(t){t===!0!==this.dashed&&(this.needsUpdate=!0),t===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(t){this.uniforms.dashScale.value=t}get dashSize(){return this.uniforms.dashSize.value}set dashSize(t){this.uniforms.dashSize.value=t}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(t){this.uniforms.dashOffset.value=t}get gapSize(){return this.uniforms.gapSize.value}set gapSize(t){this.uniforms.gapSize.value=t}get opacity(){return this.uniforms.opacity.value}set opacity(t){this.uniforms&&(this.uniforms.opacity.value=t)}get resolution(){return this.uniforms.resolution.value}set resolution(t){this.uniforms.resolution.value.copy(t)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(t){this.defines&&(t===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),t===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var p_=new en,cu=new O,zr=class extends ka{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let t=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],e=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new Ze(t,3)),this.setAttribute("uv",new Ze(e,2))}applyMatrix4(t){let e=this.attributes.instanceStart,n=this.attributes.instanceEnd;return e!==void 0&&(e.applyMatrix4(t),n.applyMatrix4(t),e.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let n=new ar(e,6,1);return this.setAttribute("instanceStart",new $i(n,3,0)),this.setAttribute("instanceEnd",new $i(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let n=new ar(e,6,1);return this.setAttribute("instanceColorStart",new $i(n,3,0)),this.setAttribute("instanceColorEnd",new $i(n,3,3)),this}fromWireframeGeometry(t){return this.setPositions(t.attributes.position.array),this}fromEdgesGeometry(t){return this.setPositions(t.attributes.position.array),this}fromMesh(t){return this.fromWireframeGeometry(new Ia(t.geometry)),this}fromLineSegments(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new en);let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;t!==void 0&&e!==void 0&&(this.boundingBox.setFromBufferAttribute(t),p_.setFromBufferAttribute(e),this.boundingBox.union(p_))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Fi),this.boundingBox===null&&this.computeBoundingBox();let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;if(t!==void 0&&e!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)cu.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(cu)),cu.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(cu));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};var $f=new Ie,m_=new O,g_=new O,Wn=new Ie,Xn=new Ie,ms=new Ie,Yf=new O,Zf=new be,qn=new za,__=new O,hu=new en,uu=new Fi,gs=new Ie,_s,Vr;function x_(i,t,e){return gs.set(0,0,-t,1).applyMatrix4(i.projectionMatrix),gs.multiplyScalar(1/gs.w),gs.x=Vr/e.width,gs.y=Vr/e.height,gs.applyMatrix4(i.projectionMatrixInverse),gs.multiplyScalar(1/gs.w),Math.abs(Math.max(gs.x,gs.y))}function fT(i,t){let e=i.matrixWorld,n=i.geometry,s=n.attributes.instanceStart,r=n.attributes.instanceEnd,o=Math.min(n.instanceCount,s.count);for(let a=0,l=o;a<l;a++){qn.start.fromBufferAttribute(s,a),qn.end.fromBufferAttribute(r,a),qn.applyMatrix4(e);let c=new O,h=new O;_s.distanceSqToSegment(qn.start,qn.end,h,c),h.distanceTo(c)<Vr*.5&&t.push({point:h,pointOnLine:c,distance:_s.origin.distanceTo(h),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function pT(i,t,e){let n=t.projectionMatrix,r=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,h=Math.min(a.instanceCount,l.count),u=-t.near;_s.at(1,ms),ms.w=1,ms.applyMatrix4(t.matrixWorldInverse),ms.applyMatrix4(n),ms.multiplyScalar(1/ms.w),ms.x*=r.x/2,ms.y*=r.y/2,ms.z=0,Yf.copy(ms),Zf.multiplyMatrices(t.matrixWorldInverse,o);for(let d=0,f=h;d<f;d++){if(Wn.fromBufferAttribute(l,d),Xn.fromBufferAttribute(c,d),Wn.w=1,Xn.w=1,Wn.applyMatrix4(Zf),Xn.applyMatrix4(Zf),Wn.z>u&&Xn.z>u)continue;if(Wn.z>u){let M=Wn.z-Xn.z,b=(Wn.z-u)/M;Wn.lerp(Xn,b)}else if(Xn.z>u){let M=Xn.z-Wn.z,b=(Xn.z-u)/M;Xn.lerp(Wn,b)}Wn.applyMatrix4(n),Xn.applyMatrix4(n),Wn.multiplyScalar(1/Wn.w),Xn.multiplyScalar(1/Xn.w),Wn.x*=r.x/2,Wn.y*=r.y/2,Xn.x*=r.x/2,Xn.y*=r.y/2,qn.start.copy(Wn),qn.start.z=0,qn.end.copy(Xn),qn.end.z=0;let v=qn.closestPointToPointParameter(Yf,!0);qn.at(v,__);let g=Ka.lerp(Wn.z,Xn.z,v),p=g>=-1&&g<=1,y=Yf.distanceTo(__)<Vr*.5;if(p&&y){qn.start.fromBufferAttribute(l,d),qn.end.fromBufferAttribute(c,d),qn.start.applyMatrix4(o),qn.end.applyMatrix4(o);let M=new O,b=new O;_s.distanceSqToSegment(qn.start,qn.end,b,M),e.push({point:b,pointOnLine:M,distance:_s.origin.distanceTo(b),object:i,face:null,faceIndex:d,uv:null,uv1:null})}}}var du=class extends Ke{constructor(t=new zr,e=new Zo({color:Math.random()*16777215})){super(t,e),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let t=this.geometry,e=t.attributes.instanceStart,n=t.attributes.instanceEnd,s=new Float32Array(2*e.count);for(let o=0,a=0,l=e.count;o<l;o++,a+=2)m_.fromBufferAttribute(e,o),g_.fromBufferAttribute(n,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+m_.distanceTo(g_);let r=new ar(s,2,1);return t.setAttribute("instanceDistanceStart",new $i(r,1,0)),t.setAttribute("instanceDistanceEnd",new $i(r,1,1)),this}raycast(t,e){let n=this.material.worldUnits,s=t.camera;if(s===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),n===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=t.params.Line2!==void 0&&t.params.Line2.threshold||0;_s=t.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Vr=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),uu.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=Vr*.5;else{let u=Math.max(s.near,uu.distanceToPoint(_s.origin));c=x_(s,u,l.resolution)}if(uu.radius+=c,_s.intersectsSphere(uu)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),hu.copy(a.boundingBox).applyMatrix4(o);let h;if(n)h=Vr*.5;else{let u=Math.max(s.near,hu.distanceToPoint(_s.origin));h=x_(s,u,l.resolution)}hu.expandByScalar(h),_s.intersectsBox(hu)!==!1&&(n?fT(this,e):pT(this,s,e))}onBeforeRender(t){let e=this.material.uniforms;e&&e.resolution&&(t.getViewport($f),this.material.uniforms.resolution.value.set($f.z,$f.w))}};var mT=4e3,pl=class{constructor(t,e,n){this.program=t;this.colour=e;this.object=new du(new zr,new Zo({linewidth:n})),this.object.frustumCulled=!1,this.object.visible=!1,this.object.renderOrder=1}program;colour;object;shown=null;show(t){if(t===this.shown)return;this.shown=t;let e=[];if(t!==null){let n=Math.min(this.program.blockLast(t),this.program.blockFirst[t]+mT);for(let s=this.program.blockFirst[t];s<=n;s+=1)this.program.isStart(s)||e.push(...this.program.tipAt(s-1),...this.program.tipAt(s))}this.object.visible=e.length>0,this.object.visible&&(this.object.geometry.dispose(),this.object.geometry=new zr().setPositions(e))}restyle(){this.object.material.color.set(ce(this.colour))}},Gr=class{constructor(t,e,n){this.colour=t;let s=new Ee;s.setAttribute("position",new we(new Float32Array(3),3));let r=new kn({glslVersion:zs,depthTest:!1,uniforms:{colour:{value:new Zt},size:{value:e*n}},vertexShader:`
        uniform float size;
        void main() {
          gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
          gl_PointSize = size;
        }
      `,fragmentShader:`
        uniform vec3 colour;
        out vec4 fragment;
        void main() {
          float r = length(gl_PointCoord * 2.0 - 1.0);
          if (r > 0.95 || (r < 0.68 && r > 0.22)) discard;
          fragment = linearToOutputTexel(vec4(colour, 1.0));
        }
      `});this.object=new Mr(s,r),this.object.frustumCulled=!1,this.object.renderOrder=5}colour;object;show(t){this.object.visible=t!==null&&Number.isFinite(t[0]),t&&this.object.position.set(...t)}restyle(){this.object.material.uniforms.colour.value.set(ce(this.colour))}};var fu=class{constructor(t){this.view=t;t.container.append(this.layer),t.onFrame(()=>this.place())}view;layer=L("div",{class:"labels","aria-hidden":"true"});labels=[];set(t){this.labels=t.map(({object:e,text:n,kind:s,title:r})=>({object:e,node:L("span",{class:`label ${s}`,title:r},n)})),this.layer.replaceChildren(...this.labels.map(e=>e.node))}place(){let{width:t,height:e}=this.view.size,n=new O;for(let{object:s,node:r}of this.labels){if(r.hidden=!gT(s),r.hidden)continue;s.getWorldPosition(n).project(this.view.camera);let o=(n.x+1)*t/2,a=(1-n.y)*e/2;r.style.transform=`translate(${o.toFixed(1)}px, ${a.toFixed(1)}px) translate(-50%, -50%)`}}};function gT(i){for(let t=i;t;t=t.parent)if(!t.visible)return!1;return!0}var pu=class{list=[];listeners=[];add(t){this.list.push(t),t.apply(t.visible)}get(t){return this.list.find(e=>e.name===t)}set(t,e){let n=this.get(t);if(n){n.visible=e,n.apply(e);for(let s of this.listeners)s()}}toggle(t){this.set(t,!this.get(t)?.visible)}onChange(t){this.listeners.push(t)}};function y_(i){let t=_T(i.profile??[]),e=t.at(-1)?.[0]??0,n=Math.min(i.flute_length??e,e),[s,r]=t.length<2?[[],[]]:xT(t,n);return{cutting:s,shank:r,unknown:i.gauge_length!==null&&e<i.gauge_length-1e-6?[e,i.gauge_length]:null}}function _T(i){return i.length===0||i[0][1]<1e-9?i:[[i[0][0],0],...i]}function xT(i,t){let e=i.filter(l=>l[0]<=t),n=i.filter(l=>l[0]>t);if(n.length===0)return[e,[]];let s=e.at(-1);if(!s)return[[],n];let r=n[0],o=(t-s[0])/(r[0]-s[0]),a=[t,s[1]+o*(r[1]-s[1])];return t-s[0]>1e-9&&e.push(a),[e,[a,...n]]}var yT=40,mu=class{object=new fn;cutting=new di({flatShading:!1,transparent:!0,opacity:.92});shank=new di({transparent:!0,opacity:.92});holder=new di({transparent:!0,opacity:.92});line=new ui;constructor(t){this.object.name="tool",this.object.quaternion.copy(new Gn().setFromUnitVectors(new O(0,0,1),new O(...t).normalize()))}show(t,e){this.object.traverse(c=>{(c instanceof Ke||c instanceof Ui)&&c.geometry.dispose()}),this.object.clear();let{cutting:n,shank:s,unknown:r}=y_(t);if(e&&e.length>0){let c={cutter:this.cutting,shank:this.shank,holder:this.holder};for(let{part:h,outlines:u}of e)for(let d of u)this.add(d.map(([f,m])=>[m,f]),c[h])}else this.add(n,this.cutting),this.add(s,this.shank);let o=r?r[0]:0,a=r?r[1]:t.gauge_length??t.length??0,l=new Ee;l.setAttribute("position",new we(new Float32Array([0,0,o,0,0,a]),3)),this.object.add(new Ui(l,this.line))}restyle(){this.cutting.color.set(ce("--tool-cutting")),this.shank.color.set(ce("--tool-shank")),this.holder.color.set(ce("--tool-holder")),this.line.color.set(ce("--tool-line"))}add(t,e){if(t.length<2)return;let n=new Pa(t.map(([s,r])=>new Xt(Math.max(r,0),s)),yT);n.rotateX(Math.PI/2),this.object.add(new Ke(n,e))}};var gu=["table","head","bed"],_u=class{constructor(t){this.machine=t;let e=n=>({table:n(),head:n(),bed:n()});this.solid=e(()=>new di({flatShading:!0,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1})),this.edge=e(()=>new ui({transparent:!0})),this.arrowLine=e(()=>new ui),this.arrowHead=e(()=>new Co),this.axes=t.joints.map(()=>0),this.workpiece.name="workpiece",this.links.push(this.workpiece);for(let n of t.joints){let s=new fn;s.name=`joint ${n.letter}`,this.links.at(-1)?.add(s),this.links.push(s)}for(let n of this.links){n.matrixAutoUpdate=!1;for(let s of gu)this.bodies[s].push(this.child(n));this.slides.push(this.child(n)),this.centreLines.push(this.child(n)),this.arrows.push(this.child(n)),this.slideArrows.push(this.child(n))}this.tool=new mu(t.tool_axis),this.links.at(-1)?.add(this.tool.object)}machine;workpiece=new fn;tool;labels=[];unitMm=1;links=[];attached=[];bodies={table:[],head:[],bed:[]};slides=[];centreLines=[];arrows=[];slideArrows=[];solid;edge;arrowLine;arrowHead;centre=new Da({dashSize:1,gapSize:1});points=[];axes;fixed="machine";build(t,e,n){this.points=t.points;for(let r of[...gu.flatMap(o=>this.bodies[o]),...this.slides,...this.centreLines,...this.arrows,...this.slideArrows])ST(r);this.labels=[];let s=Rg({machine:this.machine,...t});this.unitMm=s.unitMm,this.centre.dashSize=.3*s.unitMm,this.centre.gapSize=.08*s.unitMm;for(let r of s.bodies)this.addBody(r);for(let r of s.arrows)this.addArrow(r);this.tool.show(e,n),this.move(this.axes)}attach(t,e){this.links[e].add(t),this.attached.push(t)}material(t){return this.solid[t]}edgeMaterial(t){return this.edge[t]}move(t){if(this.axes=t,this.machine.joints.forEach((e,n)=>{this.links[n+1].matrix.fromArray(Wu(e,this.points[n],t[n]))}),this.workpiece.matrix.identity(),this.fixed==="machine"){let e=new be;for(let n=1;n<=this.machine.frame_after;n+=1)e.multiply(this.links[n].matrix);this.workpiece.matrix.copy(e.invert())}this.workpiece.updateMatrixWorld(!0)}hold(t){this.fixed=t,this.move(this.axes)}drawnJoints(){return this.machine.joints.map((t,e)=>Rp(t,this.links[e+1].matrix.elements,this.axes[e]))}drawnTip(){let t=this.workpiece.matrixWorld.clone().invert(),e=new O().setFromMatrixPosition(t.multiply(this.tool.object.matrixWorld));return[e.x,e.y,e.z]}drawnToolAxis(){let t=this.workpiece.matrixWorld.clone().invert(),e=new O().setFromMatrixColumn(t.multiply(this.tool.object.matrixWorld),2);return[e.x,e.y,e.z]}setStyle(t){for(let e of gu){let n=this.solid[e];n.visible=t!=="off",n.transparent=t==="ghost",n.opacity=t==="ghost"?.16:1,n.depthWrite=t==="solid",n.needsUpdate=!0,this.edge[e].visible=t!=="off",this.edge[e].opacity=t==="ghost"?.55:.8}}showSide(t,e){for(let n of this.bodies[t])n.visible=e}showSlides(t){for(let e of this.slides)e.visible=t}coreBox(){let t=new en;for(let e of[...this.bodies.table,...this.bodies.head,this.tool.object])t.expandByObject(e,!0);return t}places(t){let e=[...this.bodies.table,...this.bodies.head,this.tool.object];t&&e.push(...this.bodies.bed,...this.slides,...this.centreLines,...this.arrows,...this.slideArrows,...this.attached);let n=[],s=new en;for(let r of e)r.traverseVisible(o=>{if(!(o instanceof Ke||o instanceof Ui)){this.labels.some(l=>l.object===o)&&n.push(new O().setFromMatrixPosition(o.matrixWorld));return}let a=o.geometry;a.boundingBox||a.computeBoundingBox(),s.copy(a.boundingBox??s.makeEmpty());for(let l of[s.min.x,s.max.x])for(let c of[s.min.y,s.max.y])for(let h of[s.min.z,s.max.z])n.push(new O(l,c,h).applyMatrix4(o.matrixWorld))});return n}showCentreLines(t){for(let e of this.centreLines)e.visible=t}showArrows(t,e){for(let n of this.arrows)n.visible=t;for(let n of this.slideArrows)n.visible=e}restyle(){for(let t of gu)this.solid[t].color.set(ce(`--${t}-body`)),this.edge[t].color.set(ce(`--${t}-edge`)),this.arrowLine[t].color.set(ce(`--${t}-arrow`)),this.arrowHead[t].color.set(ce(`--${t}-arrow`));this.centre.color.set(ce("--centre-line")),this.tool.restyle()}child(t){let e=new fn;return t.add(e),e}addBody(t){let{shape:e,side:n,link:s}=t;if(e.shape==="line"){let a=t.role==="centre-line",l=a?this.centre:t.role==="rail"?this.edge[n]:this.arrowLine[n],c=new Ui(v_([e.from,e.to]),l);a&&c.computeLineDistances(),(a?this.centreLines:t.role==="rail"?this.slides:this.bodies[n])[s].add(c);return}let r=new Ke(e.shape==="cylinder"?new Ro(e.radius,e.radius,e.height,48):new ir(...e.size),this.solid[n]);if(e.shape==="cylinder")r.quaternion.setFromUnitVectors(new O(0,1,0),new O(...e.axis));else{let a=ci(e.along,e.across);r.quaternion.setFromRotationMatrix(new be().makeBasis(new O(...e.along),new O(...e.across),new O(...a)))}r.position.set(...e.centre),r.add(new Ti(new wr(r.geometry,25),this.edge[n])),(t.role==="carriage"||t.role==="rail"||t.role==="stop"?this.slides:this.bodies[n])[s].add(r)}addArrow(t){let e=this.machine.joints[t.joint],n=(e.rotary?this.arrows:this.slideArrows)[t.link],{path:s,side:r}=t,o=s.kind==="straight"?vT(s):bT(s),a=o[o.length-1],l=o[o.length-2];if(!t.held){let f=new Ke(new Ra(.045*this.unitMm,.15*this.unitMm,16),this.arrowHead[r]);f.quaternion.copy(new Gn().setFromUnitVectors(new O(0,1,0),new O(...no(tn(a,l))))),f.position.set(...a),n.add(new Ui(v_(o),this.arrowLine[r]),f)}let c=new fn,h=.14*this.unitMm,u=no(tn(a,l));c.position.set(...t.held?o[0]:Me(a,Qt(u,h))),n.add(c);let d=r==="table"?"workpiece side":"tool side";this.labels.push({object:c,text:t.held?`${e.letter} held`:`${e.letter}+`,kind:r,title:t.held?`${e.letter} is held`:`${e.letter}: the body moves along the arrow while the value grows (${d})`})}},vT=i=>[i.from,Me(i.from,Qt(i.direction,i.length))];function bT(i){let t=ci(i.axis,i.from);return Array.from({length:25},(e,n)=>{let s=n/24*i.sweepRad,r=Me(Qt(i.from,Math.cos(s)),Qt(t,Math.sin(s)));return Me(i.centre,Qt(r,i.radius))})}function v_(i){let t=new Ee;return t.setAttribute("position",new we(new Float32Array(i.flat()),3)),t}function ST(i){i.traverse(t=>{(t instanceof Ke||t instanceof Ui)&&t.geometry.dispose()}),i.clear()}var MT=`
  in vec4 colour;
  in float leg;
  in float travelled;
  uniform vec2 range;
  uniform float dash;
  out vec3 shade;
  out float along;
  void main() {
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    if (leg < range.x || leg > range.y) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    shade = colour.rgb;
    along = travelled / dash;
  }
`,wT=`
  in vec3 shade;
  in float along;
  out vec4 fragment;
  void main() {
    if (fract(along) > 0.55) discard;
    fragment = vec4(shade, 1.0);
  }
`,xu=class{constructor(t,e,n){this.program=t;let s=[];for(let o=0;o<t.count;o+=1)t.isStart(o)||s.push(o);this.legs=Uint32Array.from(s),this.colouring=e;let r=new kn({glslVersion:zs,vertexShader:MT,fragmentShader:wT,uniforms:{range:{value:[0,t.count]},dash:{value:this.dashMm()}}});this.object=new Ti(this.geometry(),r),this.object.name="path",this.object.frustumCulled=!1,this.colour(e,n)}program;object;legs;colouring;shares=new Float32Array(0);colour(t,e){this.colouring=t,this.shares=t.shares(),this.restyle(e)}restyle(t){let e=this.colouring.table(t).map(o=>o.map(a=>Math.round(a*255))),n=new Zt(ce("--path-unknown")).convertLinearToSRGB().toArray().map(o=>Math.round(o*255)),s=this.object.geometry.getAttribute("colour"),r=s.array;this.legs.forEach((o,a)=>{let l=this.shares[o],c=l<0?n:e[Math.min(Math.floor(l*ws),ws-1)];for(let h=8*a;h<8*a+8;h+=4)r[h]=c[0],r[h+1]=c[1],r[h+2]=c[2]}),s.needsUpdate=!0}show(t,e){this.object.material.uniforms.range.value=[t,e]}box(t,e,n){let{tip:s}=this.program,r=a=>{let l=new en,c=new O;for(let h=t;h<e;h+=1)a(h)&&Number.isFinite(s[0][h])&&l.expandByPoint(c.set(s[0][h],s[1][h],s[2][h]));return l},o=n?r(a=>!this.program.isRapid(a)&&!this.program.isStart(a)):new en;return o.isEmpty()?r(()=>!0):o}dashMm(){let t=this.box(0,this.program.count,!1).getSize(new O).length();return Math.max(t/90,.001)}geometry(){let{program:t,legs:e}=this,n=new Float32Array(6*e.length),s=new Float32Array(2*e.length),r=new Float32Array(2*e.length),o=0;for(let l=0;l<e.length;l+=1){let c=e[l],h=0;for(let u=0;u<3;u+=1){let d=t.tip[u][c-1],f=t.tip[u][c];n[6*l+u]=d,n[6*l+3+u]=f,h+=(f-d)**2}s[2*l]=s[2*l+1]=c,t.isRapid(c)?(r[2*l]=o,o+=Math.sqrt(h),r[2*l+1]=o):o=0}let a=new Ee;return a.setAttribute("position",new we(n,3)),a.setAttribute("colour",new we(new Uint8Array(8*e.length),4,!0)),a.setAttribute("leg",new we(s,1)),a.setAttribute("travelled",new we(r,1)),a}};function b_(i){let{tip:t,clipFromWorkpiece:e,width:n,height:s,x:r,y:o}=i,a=null,l=Number.POSITIVE_INFINITY,[c,h,u]=[0,0,0],d=!1;for(let f=Math.max(i.first-1,0);f<=i.last;f+=1){let[m,v,g]=[t[0][f],t[1][f],t[2][f]],p=e[3]*m+e[7]*v+e[11]*g+e[15],y=((e[0]*m+e[4]*v+e[8]*g+e[12])/p+1)*n/2,M=(1-(e[1]*m+e[5]*v+e[9]*g+e[13])/p)*s/2,b=(e[2]*m+e[6]*v+e[10]*g+e[14])/p;if(d&&f>=i.first&&i.drawn(f)){let C=y-c,A=M-h,_=C*C+A*A,w=_>0?Math.min(Math.max(((r-c)*C+(o-h)*A)/_,0),1):1,U=Math.hypot(r-c-w*C,o-h-w*A);if(U<=9){let F=Math.floor(U/3)*4+u+w*(b-u);F<l&&(l=F,a=f)}}[c,h,u]=[y,M,b],d=Number.isFinite(y+M)}return a}var yu=class{constructor(t){this.stage=t;let[e,n]=t.corners,[s,r,o]=t.counts;this.counts=t.counts,this.low=e,this.pitch=[0,1,2].map(a=>(n[a]-e[a])/t.counts[a]),this.first=[0,r*o,r*o+o*s],this.reset()}stage;counts;low;pitch;spans=[];done=0;first;seek(t){let{removed:e}=this.stage,n=TT(e.line,t);if(n===this.done)return!1;for(n<this.done&&this.reset();this.done<n;this.done+=1)this.remove(e,this.done);return!0}material(t,e,n){return this.spans[this.first[t]+n*this.counts[(t+1)%3]+e]}volume(){let t=0;for(let e=this.first[2];e<this.spans.length;e+=1){let n=this.spans[e];for(let s=0;s<n.length;s+=2)t+=n[s+1]-n[s]}return t*this.pitch[0]*this.pitch[1]}reset(){let[t,e,n]=this.counts,{material:s}=this.stage;this.spans=Array.from({length:e*n+n*t+t*e},()=>[]);for(let r=0;r<s.stockLine.length;r+=1)this.spans[s.stockLine[r]].push(s.low[r],s.high[r]);this.done=0}remove(t,e){let n=t.stockLine[e],[s,r]=[t.low[e],t.high[e]],o=this.spans[n],a=[];for(let l=0;l<o.length;l+=2){let[c,h]=[o[l],o[l+1]];if(h<=s||c>=r){a.push(c,h);continue}c<s&&a.push(c,s),h>r&&a.push(r,h)}this.spans[n]=a}};function TT(i,t){let[e,n]=[0,i.length];for(;e<n;){let s=e+n>>1;i[s]<=t?e=s+1:n=s}return e}function S_(i){let[t,e,n]=i.counts,s=(p,y)=>i.low[p]+(y-.5)*i.pitch[p],[r,o]=[t+2,e+2],a=new Uint8Array(r*o*(n+2));for(let p=1;p<=e;p+=1)for(let y=1;y<=t;y+=1){let M=i.material(2,y-1,p-1);for(let b=0;b<M.length;b+=2){let C=Math.max(1,Math.ceil((M[b]-i.low[2])/i.pitch[2]+.5)),A=Math.min(n,Math.floor((M[b+1]-i.low[2])/i.pitch[2]+.5));for(let _=C;_<=A;_+=1)a[(_*o+p)*r+y]=1}}let l=(p,y,M)=>{let[b,C]=[s(p,y[p]),s(p,y[p]+1)],A=i.material(p,y[(p+1)%3]-1,y[(p+2)%3]-1)??[],_=Number.NaN;for(let w=M?1:0;w<A.length;w+=2){let U=A[w];U>=b&&U<=C&&!(M?_<=U:_>=U)&&(_=U)}return Number.isNaN(_)?(b+C)/2:_},[c,h]=[t+1,e+1],u=new Int32Array(c*h*(n+1)).fill(-1),d=[],f=[0,1,r,r+1,r*o,r*o+1,r*o+r,r*o+r+1];for(let p=0;p<=n;p+=1)for(let y=0;y<=e;y+=1)for(let M=0;M<=t;M+=1){let b=(p*o+y)*r+M,C=0;for(let w=0;w<8;w+=1)C|=a[b+f[w]]<<w;if(C===0||C===255)continue;let A=[0,0,0],_=0;for(let w=0;w<3;w+=1)for(let U=0;U<8;U+=1){if(U>>w&1)continue;let F=C>>U&1;if(F===(C>>(U|1<<w)&1))continue;let I=[M+(U&1),y+(U>>1&1),p+(U>>2)];for(let V=0;V<3;V+=1)A[V]+=V===w?l(w,I,F===1):s(V,I[V]);_+=1}u[(p*h+y)*c+M]=d.length/3,d.push(A[0]/_,A[1]/_,A[2]/_)}let m=[],v=(p,y,M)=>u[(M*h+y)*c+p],g=(p,y,M,b,C)=>{C?m.push(p,y,M,p,M,b):m.push(p,b,M,p,M,y)};for(let p=0;p<=n;p+=1)for(let y=0;y<=e;y+=1)for(let M=0;M<=t;M+=1){let b=(p*o+y)*r+M,C=a[b]===1;M>0&&y>0&&C!==(a[b+r*o]===1)&&g(v(M-1,y-1,p),v(M,y-1,p),v(M,y,p),v(M-1,y,p),C),y>0&&p>0&&C!==(a[b+1]===1)&&g(v(M,y-1,p-1),v(M,y,p-1),v(M,y,p),v(M,y-1,p),C),M>0&&p>0&&C!==(a[b+r]===1)&&g(v(M-1,y,p-1),v(M-1,y,p),v(M,y,p),v(M,y,p-1),C)}return{positions:new Float32Array(d),faces:new Uint32Array(m)}}var ET=25,vu=class{constructor(t,e,n,s,r){this.simulation=t;this.program=e;this.machine=n;this.theme=r;let{design:o}=t.figures;this.limits=o?Yo(o):null,this.part.matrixAutoUpdate=!1,this.cut=new Ke(new Ee,new di({flatShading:!0})),this.cut.name="stock as it is cut",this.ring=new Gr("--mark-finding",22,s),this.ring.object.visible=!1,n.workpiece.add(this.part,this.cut,this.ring.object);for(let a=0;a<=e.head.machine.joints.length;a+=1){let l=new fn;this.links.push(l),n.attach(l,a)}for(let a of t.bodies)if(a.role==="machined")this.machined=new Ke(Kf(a),new di({flatShading:!0,vertexColors:!0,side:Ai})),this.machined.name=a.name,this.part.add(this.machined);else if(a.role==="design"){let l=Kf(a);l.computeVertexNormals(),this.design.add(new Ke(l,this.designMaterial)),this.part.add(this.design)}else this.addSolid(a)}simulation;program;machine;theme;stock="result";limits;machined=null;cut;part=new fn;design=new fn;designMaterial=new di({transparent:!0,opacity:.45,depthWrite:!1,side:Ai});fixtureMaterial=new di({flatShading:!0,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1});links=[];solids=[];ring;stages=new Map;setUp=-1;position=0;cutIsOld=!0;shownLines=null;solidsVisible=!0;placeSetUp=null;get hasSolids(){return this.solids.length>0}get hasDesign(){return this.design.children.length>0}get hasStages(){return this.simulation.stages!==null}showStock(t){this.stock=t,this.showParts()}showDesign(t){this.design.visible=t}showSolids(t){this.solidsVisible=t,this.showParts()}mark(t,e){let n=e===null?this.part:this.machine.workpiece;this.ring.object.parent!==n&&n.add(this.ring.object),this.placeSetUp=e,this.ring.show(t),e!==null&&e!==this.setUp&&(this.ring.object.visible=!1)}place(t){let e=this.program.head.placements[t].set_up;this.setUp=e,this.links.forEach((s,r)=>{let o=this.simulation.linkPlaces[t]?.[r];o&&s.position.set(...o)});let n=this.simulation.partPlaces[e];n&&this.part.matrix.fromArray(n),this.part.matrixWorldNeedsUpdate=!0,this.placeSetUp!==null&&this.placeSetUp!==e&&(this.ring.object.visible=!1),this.cutIsOld=!0,this.showParts()}seek(t){this.position=t,this.cutIsOld=!0}prepare(){if(this.stock!=="cut"||!this.cutIsOld)return;this.cutIsOld=!1;let t=this.stage(),e=this.shownLines;if(this.shownLines=t?this.linesOf(t):null,this.cut.visible=this.shownLines!==null,!this.shownLines||!this.shownLines.seek(this.doneLine())&&e===this.shownLines)return;let{positions:s,faces:r}=S_(this.shownLines);this.cut.geometry.dispose(),this.cut.geometry=new Ee,this.cut.geometry.setAttribute("position",new we(s,3)),this.cut.geometry.setIndex(new we(r,1))}volume(){let t=this.stage();if(!t)return null;let e=this.linesOf(t);return e.seek(this.doneLine()),this.cutIsOld=!0,this.shownLines=null,e.volume()}origins(){let t=this.machine.workpiece.matrixWorld.clone().invert();return Object.fromEntries(this.solids.map(({body:e,mesh:n})=>{let{elements:s}=new be().multiplyMatrices(t,n.matrixWorld);return[e.name,[s[12],s[13],s[14]]]}))}restyle(t){if(this.theme=t,this.machined){let e=this.simulation.bodies.find(r=>r.role==="machined"),n=this.machined.geometry.getAttribute("position").count,s=h_(e?.deviations??null,n,this.limits,t,M_);this.machined.geometry.setAttribute("color",new we(s,3))}this.cut.material.color.setRGB(...M_(dl(this.theme))),this.designMaterial.color.set(ce("--design-body")),this.fixtureMaterial.color.set(ce("--fixture-body")),this.ring.restyle()}addSolid(t){let{frame_after:e}=this.program.head.machine,n=t.link===e?"bed":t.link<e?"table":"head",s=t.role==="fixture",r=Kf(t),o=new Ke(r,s?this.fixtureMaterial:this.machine.material(n));o.name=t.name;let a=this.machine.edgeMaterial(s?"bed":n);o.add(new Ti(new wr(r,ET),a)),this.links[t.link].add(o),this.solids.push({body:t,mesh:o})}showParts(){let t=this.simulation.partPlaces[this.setUp]!==null;this.machined&&(this.machined.visible=this.stock==="result"&&t),this.part.visible=t,this.cut.visible=this.stock==="cut";for(let{body:e,mesh:n}of this.solids)n.visible=this.solidsVisible&&(e.setUps.length===0||e.setUps.includes(this.setUp))}stage(){return this.simulation.stages?.find(t=>t.setUp===this.setUp)??null}linesOf(t){let e=this.stages.get(t)??new yu(t);return this.stages.set(t,e),e}doneLine(){let{program:t}=this,e=Math.floor(this.position),n=t.line[e];return e===t.blockLast(t.block[e])?n:n-1}},M_=i=>{let{r:t,g:e,b:n}=new Zt().setRGB(...i,"srgb");return[t,e,n]};function Kf(i){let t=new Ee;return t.setAttribute("position",new we(i.positions,3)),t.setIndex(new we(i.faces,1)),t}var jf=["X","Y","Z"],bu=class{object=new fn;labels=[];material=new ui;constructor(){let t=new Ee;t.setAttribute("position",new we(new Float32Array([0,0,0,1,0,0,0,0,0,0,1,0,0,0,0,0,0,1]),3)),this.object.add(new Ti(t,this.material)),jf.forEach((e,n)=>{let s=new fn;s.position.setComponent(n,1.12),this.object.add(s),this.labels.push({object:s,text:e,kind:"origin",title:`workpiece ${e}`})})}size(t){this.object.scale.setScalar(t),this.object.updateMatrixWorld(!0)}restyle(){this.material.color.set(ce("--origin"))}},Su=class{constructor(t){this.view=t;let e="http://www.w3.org/2000/svg",n=document.createElementNS(e,"svg");n.setAttribute("viewBox","-36 -36 72 72"),n.setAttribute("aria-hidden","true"),jf.forEach((s,r)=>{let o=document.createElementNS(e,"line");o.setAttribute("class",`axis-${s.toLowerCase()}`);let a=document.createElementNS(e,"text");a.textContent=s,n.append(o,a),this.lines[r]=o,this.texts[r]=a}),t.container.append(L("div",{class:"corner"},n,this.caption)),t.onFrame(()=>this.turn())}view;lines=[];texts=[];caption=L("span");name(t){this.caption.textContent=t}turn(){let t=new O().setFromMatrixColumn(this.view.camera.matrixWorld,0),e=new O().setFromMatrixColumn(this.view.camera.matrixWorld,1);jf.forEach((n,s)=>{let r=new O().setComponent(s,1),o=r.dot(t),a=-r.dot(e);this.lines[s].setAttribute("x2",(22*o).toFixed(2)),this.lines[s].setAttribute("y2",(22*a).toFixed(2)),this.texts[s].setAttribute("x",(30*o).toFixed(2)),this.texts[s].setAttribute("y",(30*a).toFixed(2))})}};var w_={type:"change"},Qf={type:"start"},E_={type:"end"},Mu=new er,T_=new Si,AT=Math.cos(70*Ka.DEG2RAD),Pn=new O,pi=2*Math.PI,Pe={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Jf=1e-6,wu=class extends Va{constructor(t,e=null){super(t,e),this.state=Pe.NONE,this.target=new O,this.cursor=new O,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:lr.ROTATE,MIDDLE:lr.DOLLY,RIGHT:lr.PAN},this.touches={ONE:cr.ROTATE,TWO:cr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new O,this._lastQuaternion=new Gn,this._lastTargetPosition=new O,this._quat=new Gn().setFromUnitVectors(t.up,new O(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Lo,this._sphericalDelta=new Lo,this._scale=1,this._panOffset=new O,this._rotateStart=new Xt,this._rotateEnd=new Xt,this._rotateDelta=new Xt,this._panStart=new Xt,this._panEnd=new Xt,this._panDelta=new Xt,this._dollyStart=new Xt,this._dollyEnd=new Xt,this._dollyDelta=new Xt,this._dollyDirection=new O,this._mouse=new Xt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=RT.bind(this),this._onPointerDown=CT.bind(this),this._onPointerUp=PT.bind(this),this._onContextMenu=OT.bind(this),this._onMouseWheel=DT.bind(this),this._onKeyDown=NT.bind(this),this._onTouchStart=FT.bind(this),this._onTouchMove=UT.bind(this),this._onMouseDown=LT.bind(this),this._onMouseMove=IT.bind(this),this._interceptControlDown=BT.bind(this),this._interceptControlUp=kT.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Pe.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(w_),this.update(),this.state=Pe.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Pn.copy(e).sub(this.target),Pn.applyQuaternion(this._quat),this._spherical.setFromVector3(Pn),this.autoRotate&&this.state===Pe.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=pi:n>Math.PI&&(n-=pi),s<-Math.PI?s+=pi:s>Math.PI&&(s-=pi),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Pn.setFromSpherical(this._spherical),Pn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Pn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Pn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new O(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new O(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Pn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Mu.origin.copy(this.object.position),Mu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Mu.direction))<AT?this.object.lookAt(this.target):(T_.setFromNormalAndCoplanarPoint(this.object.up,this.target),Mu.intersectPlane(T_,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Jf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Jf||this._lastTargetPosition.distanceToSquared(this.target)>Jf?(this.dispatchEvent(w_),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?pi/60*this.autoRotateSpeed*t:pi/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Pn.setFromMatrixColumn(e,0),Pn.multiplyScalar(-t),this._panOffset.add(Pn)}_panUp(t,e){this.screenSpacePanning===!0?Pn.setFromMatrixColumn(e,1):(Pn.setFromMatrixColumn(e,0),Pn.crossVectors(this.object.up,Pn)),Pn.multiplyScalar(t),this._panOffset.add(Pn)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Pn.copy(s).sub(this.target);let r=Pn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(pi*this._rotateDelta.x/e.clientHeight),this._rotateUp(pi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(pi*this._rotateDelta.x/e.clientHeight),this._rotateUp(pi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Xt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function CT(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function RT(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function PT(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(E_),this.state=Pe.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function LT(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case lr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Pe.DOLLY;break;case lr.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Pe.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Pe.ROTATE}break;case lr.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Pe.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Pe.PAN}break;default:this.state=Pe.NONE}this.state!==Pe.NONE&&this.dispatchEvent(Qf)}function IT(i){switch(this.state){case Pe.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Pe.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Pe.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function DT(i){this.enabled===!1||this.enableZoom===!1||this.state!==Pe.NONE||(i.preventDefault(),this.dispatchEvent(Qf),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(E_))}function NT(i){this.enabled!==!1&&this._handleKeyDown(i)}function FT(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case cr.ROTATE:if(this.enableRotate===!1){this.state=Pe.NONE;break}this._handleTouchStartRotate(i),this.state=Pe.TOUCH_ROTATE;break;case cr.PAN:if(this.enablePan===!1){this.state=Pe.NONE;break}this._handleTouchStartPan(i),this.state=Pe.TOUCH_PAN;break;default:this.state=Pe.NONE}break;case 2:switch(this.touches.TWO){case cr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Pe.TOUCH_DOLLY_PAN;break;case cr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Pe.TOUCH_DOLLY_ROTATE;break;default:this.state=Pe.NONE}break;default:this.state=Pe.NONE}this.state!==Pe.NONE&&this.dispatchEvent(Qf)}function UT(i){switch(this._trackPointer(i),this.state){case Pe.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Pe.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Pe.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Pe.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Pe.NONE}}function OT(i){this.enabled!==!1&&i.preventDefault()}function BT(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function kT(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Ko={iso:{label:"Isometric",key:"1",eye:[1,-1.25,.9],up:[0,0,1]},top:{label:"Top",key:"2",eye:[0,0,1],up:[0,1,0]},front:{label:"Front",key:"3",eye:[0,-1,0],up:[0,0,1]},right:{label:"Right",key:"4",eye:[1,0,0],up:[0,0,1]},left:{label:"Left",key:"5",eye:[-1,0,0],up:[0,0,1]},back:{label:"Back",key:"6",eye:[0,1,0],up:[0,0,1]},bottom:{label:"Bottom",key:"7",eye:[0,0,-1],up:[0,-1,0]}},zT=2e4,ml={top:56,bottom:22,side:28},Tu=class{constructor(t,e){this.container=t;this.renderer=new Ph({antialias:e<zT||!VT(),powerPreference:"high-performance"});let n=this.renderer.domElement;n.setAttribute("role","img"),n.setAttribute("aria-label","Tool path and machine in 3-D. Drag to orbit; press ? for the keys."),t.append(n),this.camera.up.set(0,0,1),this.camera.position.set(1,-1.25,.9).normalize(),this.controls=new wu(this.camera,n),this.controls.enableDamping=!1,this.controls.zoomToCursor=!0,this.controls.addEventListener("change",()=>this.request());let s=new Ua(16777215,9278620,1.9);s.position.set(0,0,1);let r=new Ba(16777215,1.5);r.position.set(.4,-.8,1),this.scene.add(s,r),new ResizeObserver(()=>this.resize()).observe(t),this.resize(),this.restyle()}container;scene=new Ma;camera=new Tr(-1,1,1,-1,-1e5,1e5);controls;renderer;beforeFrame=[];scheduled=!1;width=1;height=1;get canvas(){return this.renderer.domElement}get size(){return{width:this.width,height:this.height}}get mmPerPixel(){return(this.camera.top-this.camera.bottom)/this.camera.zoom/this.height}onFrame(t){this.beforeFrame.push(t)}request(){this.scheduled||(this.scheduled=!0,requestAnimationFrame(()=>{this.scheduled=!1,this.draw()}))}frameMilliseconds(){let t=this.renderer.getContext(),e=new Uint8Array(4);return[0,1,2].map(()=>{let s=performance.now();return this.draw(),t.readPixels(0,0,1,1,t.RGBA,t.UNSIGNED_BYTE,e),performance.now()-s}).sort((s,r)=>s-r)[1]}restyle(){this.scene.background=new Zt(ce("--viewport")),this.request()}fit(t){if(t.length===0)return;let e=new en().setFromPoints(t),n=Math.max(e.getSize(new O).length()/2,.5);this.place(e.getCenter(new O),n);let s=new O().setFromMatrixColumn(this.camera.matrixWorld,0),r=new O().setFromMatrixColumn(this.camera.matrixWorld,1),o=v=>{let g=t.map(p=>p.dot(v));return[g.reduce((p,y)=>Math.min(p,y)),g.reduce((p,y)=>Math.max(p,y))]},[a,l]=o(s),[c,h]=o(r),u=Math.max(this.width-2*ml.side,40),d=Math.max(this.height-ml.top-ml.bottom,40);this.camera.zoom=Math.min(u/Math.max(l-a,.5),d/Math.max(h-c,.5)),this.camera.updateProjectionMatrix();let{target:f}=this.controls,m=(ml.top-ml.bottom)/2/this.camera.zoom;this.centreOn(f.clone().addScaledVector(s,(a+l)/2-f.dot(s)).addScaledVector(r,(c+h)/2-f.dot(r)+m))}look(t,e){let{eye:n}=Ko[t],s=new en().setFromPoints(e),r=s.getCenter(new O),o=Math.max(s.getSize(new O).length()*4,10);this.controls.target.copy(r),this.camera.position.copy(r).addScaledVector(new O(n[0],n[1],n[2]).normalize(),o),n[0]===0&&n[1]===0&&(this.camera.position.y-=1e-6*o),this.camera.lookAt(r),this.controls.update(),this.fit(e)}lookFrom(t){let e=this.camera.position.distanceTo(this.controls.target);this.camera.position.copy(this.controls.target).addScaledVector(t.clone().normalize(),e),this.controls.update(),this.request()}centreOn(t){let e=t.clone().sub(this.controls.target);this.controls.target.add(e),this.camera.position.add(e),this.controls.update(),this.request()}panBy(t,e){let n=new O().setFromMatrixColumn(this.camera.matrixWorld,0),s=new O().setFromMatrixColumn(this.camera.matrixWorld,1),r=n.multiplyScalar(-t*this.mmPerPixel).addScaledVector(s,e*this.mmPerPixel);this.centreOn(this.controls.target.clone().add(r))}zoomBy(t){this.camera.zoom*=t,this.camera.updateProjectionMatrix(),this.request()}orbitBy(t,e){let n=this.camera.position.clone().sub(this.controls.target),s=n.length(),r=Math.atan2(n.y,n.x)+t,o=Math.min(Math.max(Math.asin(n.z/s)+e,-Math.PI/2+1e-4),Math.PI/2-1e-4);n.set(Math.cos(o)*Math.cos(r),Math.cos(o)*Math.sin(r),Math.sin(o)),this.camera.position.copy(this.controls.target).addScaledVector(n,s),this.controls.update(),this.request()}place(t,e){let n=this.camera.position.clone().sub(this.controls.target);n.length()<1e-9&&n.set(1,-1.25,.9),n.normalize(),this.controls.target.copy(t),this.camera.position.copy(t).addScaledVector(n,8*e),this.camera.lookAt(t),this.camera.near=-40*e,this.camera.far=60*e,this.camera.updateMatrixWorld()}resize(){this.width=Math.max(this.container.clientWidth,1),this.height=Math.max(this.container.clientHeight,1),this.renderer.setPixelRatio(Math.min(devicePixelRatio,2)),this.renderer.setSize(this.width,this.height),this.camera.left=-this.width/2,this.camera.right=this.width/2,this.camera.top=this.height/2,this.camera.bottom=-this.height/2,this.camera.updateProjectionMatrix(),this.draw()}draw(){for(let t of this.beforeFrame)t();this.renderer.render(this.scene,this.camera)}};function VT(){let i=document.createElement("canvas").getContext("webgl2"),t=i?.getExtension("WEBGL_debug_renderer_info");if(!i||!t)return!1;let e=String(i.getParameter(t.UNMASKED_RENDERER_WEBGL));return i.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|software|basic render/i.test(e)}var GT=5,Eu=class{constructor(t,e,n,s,r,o){this.program=t;this.events=n;this.theme=r;let a=Math.min(devicePixelRatio,2);this.view=new Tu(e,t.count),this.machine=new _u(t.head.machine),this.view.scene.add(this.machine.workpiece),this.simulated=o&&new vu(o,t,this.machine,a,r),this.view.onFrame(()=>this.simulated?.prepare()),this.path=new xu(t,s,r),this.currentBlock=new pl(t,"--accent",4),this.hoverBlock=new pl(t,"--hover",3),this.currentRing=new Gr("--accent",17,a),this.hoverRing=new Gr("--hover",15,a),this.hoverRing.object.visible=!1,this.machine.workpiece.add(this.path.object,this.currentBlock.object,this.hoverBlock.object,this.currentRing.object,this.hoverRing.object,this.origin.object);for(let l of Ag){let c=Nh.of(t,l,a);c&&(this.marks.push(c),this.machine.workpiece.add(c.object))}this.labels=new fu(this.view),this.corner=new Su(this.view),this.corner.name(this.fixed),this.makeLayers(),this.simulated?.hasSolids&&(this.machineStyle="ghost"),this.machine.setStyle(this.machineStyle),this.restyle(r),this.seek(0),this.simulated&&this.setFixed("part"),this.listen()}program;events;theme;view;layers=new pu;machine;simulated;fixed="machine";machineStyle="solid";extent="whole";path;marks=[];origin=new bu;labels;corner;currentBlock;hoverBlock;currentRing;hoverRing;ticks=null;placement=-1;setUp=-1;position=0;cuttingBox=new en;seek(t){this.position=t;let e=Ts.pointAt(t);this.place(this.program.placement[Math.floor(t)]),this.machine.move(this.program.axesBetween(t)),this.simulated?.seek(t),this.currentBlock.show(this.program.block[e]),this.currentRing.show(this.machine.drawnTip()),this.showRange(),this.view.request()}hover(t){this.hoverBlock.show(t===null?null:this.program.block[t]),this.hoverRing.show(t===null?null:this.program.tipAt(t)),this.view.request()}colour(t){this.path.colour(t,this.theme),this.view.request()}restyle(t){this.theme=t,this.path.restyle(t),this.machine.restyle(),this.simulated?.restyle(t),this.origin.restyle(),this.ticks?.restyle();for(let e of this.marks)e.restyle();for(let e of[this.currentBlock,this.hoverBlock,this.currentRing,this.hoverRing])e.restyle();this.view.restyle()}setFixed(t){this.fixed=t,this.machine.hold(t),this.corner.name(t);for(let e of["bed","slides","arrows"]){let n=this.layers.get(e);n&&n.apply(n.visible)}this.view.request()}setMachineStyle(t){this.machineStyle=t,this.machine.setStyle(t);let e=this.layers.get("arrows");e?.apply(e.visible),this.view.request()}setStock(t){this.simulated?.showStock(t),this.view.request()}markPlace(t,e){this.simulated?.mark(t,e),this.view.request()}setExtent(t){this.extent=t,this.showRange(),this.view.request()}pathBox(){return this.cuttingBox.clone().applyMatrix4(this.machine.workpiece.matrixWorld)}fit(t){this.view.fit(t?this.machinePlaces():gl(this.pathBox()))}look(t){this.view.look(t,this.fixed==="machine"&&this.machineStyle!=="off"?this.machinePlaces():gl(this.pathBox()))}lookFirst(){this.look("iso");let t=this.machine.coreBox().union(this.pathBox()),e=this.pathBox(),n=t.max.distanceTo(t.min)/Math.max(e.max.distanceTo(e.min),1e-6);this.view.fit(n<12&&!this.simulated?[...this.machine.places(!1),...gl(e)]:gl(e))}machinePlaces(){return[...this.machine.places(!0),...gl(this.pathBox())]}lookAlongTool(){let t=new O().setFromMatrixColumn(this.machine.tool.object.matrixWorld,2);Math.hypot(t.x,t.y)<1e-4&&(t.y-=1e-4),this.view.lookFrom(t),this.centreOnTool()}centreOnTool(){this.view.centreOn(new O().setFromMatrixPosition(this.machine.tool.object.matrixWorld))}pickAt(t,e){let{camera:n,size:s}=this.view;n.updateMatrixWorld();let r=new be().multiplyMatrices(n.projectionMatrix,n.matrixWorldInverse).multiply(this.machine.workpiece.matrixWorld),[o,a]=this.range();return b_({tip:this.program.tip,first:o,last:a,drawn:l=>!this.program.isStart(l),clipFromWorkpiece:r.elements,width:s.width,height:s.height,x:t,y:e})}place(t){if(t===this.placement)return;this.placement=t;let{program:e}=this,n=e.head.placements[t],[s,r]=e.setUpRange(n.set_up);this.setUp!==n.set_up&&(this.setUp=n.set_up,this.cuttingBox=this.path.box(s,r,!0),this.cuttingBox.expandByScalar(1));let{min:o,max:a}=this.cuttingBox,l=e.toolOfNumber(n.tool);this.machine.build({points:n.points,gaugeMm:l.gauge_length??l.length??0,box:{min:[o.x,o.y,o.z],max:[a.x,a.y,a.z]},travel:e.axes.map((c,h)=>{let[u,d]=HT(c,s,r),[f,m]=e.limits(h,t);return{min:f,max:m,low:u,high:d}})},l,this.simulated?.simulation.tools.get(n.tool)??null),this.simulated?.place(t),this.origin.size(.35*this.machine.unitMm),this.labels.set([...this.machine.labels,...this.origin.labels])}range(){let[t,e]=this.program.setUpRange(Math.max(this.setUp,0));if(this.extent==="done")return[t,Math.floor(this.position)];if(this.extent==="operation"){let n=this.program.head.operations[this.program.operation[Ts.pointAt(this.position)]];if(n)return[n.first_point,n.first_point+n.points-1]}return[t,e-1]}showRange(){let[t,e]=this.range();this.path.show(t,e);for(let n of this.marks)n.show(t,e);this.ticks?.show(t,e)}makeLayers(){let t=(o,a,l,c,h,u)=>this.layers.add({name:o,label:a,sample:l,visible:c,key:h,apply:d=>{u(d),this.view.request()}}),e=this.program.head.machine.joints.length,{frame_after:n}=this.program.head.machine,s=!(this.simulated?.hasSolids??!1);t("path","Tool path",null,!0,null,o=>{this.path.object.visible=o}),t("ticks","Tool axis ticks","sample-tick",!1,"A",o=>this.showTicks(o)),t("tool","Tool","sample-tool",!0,null,o=>{this.machine.tool.object.visible=o}),n>0&&t("table","Table side","sample-table",s,null,o=>this.machine.showSide("table",o)),n<e&&t("head","Head side","sample-head",s,null,o=>this.machine.showSide("head",o)),t("slides","Slides (bed at rest)",null,s,null,o=>{this.machine.showSlides(o&&this.fixed==="machine");let a=this.layers.get("arrows");a?.apply(a.visible)}),t("bed","Frame (bed at rest)","sample-bed",s,null,o=>this.machine.showSide("bed",o&&this.fixed==="machine")),t("centre-lines","Centre lines","sample-centre",!0,null,o=>this.machine.showCentreLines(o)),t("arrows","Axis arrows",null,!0,"L",o=>{let a=o&&this.machineStyle!=="off";this.machine.showArrows(a,a&&this.fixed==="machine"&&(this.layers.get("slides")?.visible??!0))});let{simulated:r}=this;r?.hasSolids&&t("solids","Machine solids","sample-bed",!0,null,o=>r.showSolids(o)),r?.hasDesign&&t("design","Design","sample-design",!1,"E",o=>r.showDesign(o)),t("origin","Workpiece origin",null,!0,null,o=>{this.origin.object.visible=o});for(let o of this.marks){let{label:a}=An[o.kind],l=`${a.charAt(0).toUpperCase()}${a.slice(1)}${a.startsWith("near")?"":"s"}`;t(`mark-${o.kind}`,l,`mark mark-${o.kind}`,o.kind!=="inserted",null,c=>{o.object.visible=c})}}showTicks(t){t&&!this.ticks&&(this.ticks=new Fh(this.program,.22*this.machine.unitMm),this.ticks.restyle(),this.machine.workpiece.add(this.ticks.object),this.showRange()),this.ticks&&(this.ticks.object.visible=t)}listen(){let{canvas:t}=this.view,e=null,n=!1;t.addEventListener("pointerdown",s=>{e={x:s.clientX,y:s.clientY},this.events.hover(null,0,0)}),t.addEventListener("pointerup",s=>{let r=e&&Math.hypot(s.clientX-e.x,s.clientY-e.y)<=GT;if(e=null,!r||s.button!==0)return;let o=this.pickAt(s.offsetX,s.offsetY);o!==null&&this.events.click(o)}),t.addEventListener("pointercancel",()=>{e=null}),t.addEventListener("pointermove",s=>{if(e||n||s.pointerType==="touch")return;n=!0;let{offsetX:r,offsetY:o}=s;requestAnimationFrame(()=>{n=!1,e||this.events.hover(this.pickAt(r,o),r,o)})}),t.addEventListener("pointerleave",()=>this.events.hover(null,0,0))}};function gl(i){let{min:t,max:e}=i;return[t.x,e.x].flatMap(n=>[t.y,e.y].flatMap(s=>[t.z,e.z].map(r=>new O(n,s,r))))}function HT(i,t,e){let n=Number.POSITIVE_INFINITY,s=Number.NEGATIVE_INFINITY;for(let r=t;r<e;r+=1)i[r]<n&&(n=i[r]),i[r]>s&&(s=i[r]);return n<=s?[n,s]:[0,0]}var A_=24;function tp(i,t,e,n,s,r){let o=L("div",{class:`splitter ${t}`,role:"separator",tabindex:"0","aria-label":i,"aria-orientation":t==="column"?"vertical":"horizontal","aria-valuemin":s,"aria-valuemax":r}),a=()=>{let c=t==="column"?o.previousElementSibling:o.nextElementSibling,{width:h,height:u}=c?.getBoundingClientRect()??{width:s,height:s};return t==="column"?h:u},l=c=>{let h=Math.round(Math.min(Math.max(c,s),r));e.style.setProperty(n,`${h}px`),o.setAttribute("aria-valuenow",String(h))};return o.addEventListener("pointerdown",c=>{c.preventDefault(),o.setPointerCapture(c.pointerId);let h={x:c.clientX,y:c.clientY,size:a()},u=d=>{l(h.size+(t==="column"?d.clientX-h.x:h.y-d.clientY))};o.addEventListener("pointermove",u);for(let d of["pointerup","pointercancel"])o.addEventListener(d,()=>o.removeEventListener("pointermove",u),{once:!0})}),o.addEventListener("keydown",c=>{let h=t==="column"?"ArrowRight":"ArrowUp",u=t==="column"?"ArrowLeft":"ArrowDown";c.key!==h&&c.key!==u||(c.preventDefault(),c.stopPropagation(),l(a()+(c.key===h?A_:-A_)))}),o}var C_=["now","machine","display","findings","simulation","operations"],WT={now:"Position",machine:"Machine",display:"Display",findings:"Findings",simulation:"Simulation",operations:"Operations"},Au={fit:"M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4M7 7h6v6H7z",machine:"M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4M10 6v5M7.5 11h5M8 14h4",iso:"M10 2.5l6.5 3.7v7.6L10 17.5l-6.5-3.7V6.2zM10 10l6.5-3.8M10 10v7.5M10 10L3.5 6.2",tool:"M8 3h4v7l-2 4-2-4zM10 14v3M6 17h8"},Cu=class{constructor(t,e){this.data=t;let{program:n,programText:s,clText:r}=t,{theme:o}=this.theme,a=new Tl(n);this.timeline=new ou(n),this.colourings=Tp(n),this.colouring=this.colourings[0],this.text=new ru(s,n,{select:m=>a.has(m)?this.showLine(m):this.select(m),hover:m=>this.hover.set(m===null?null:this.exactPointOfLine(m))}),this.plots=new eu(n,this.timeline,this.hover,o),this.transport=new au(n,this.timeline,o),this.blockCard=new la(n,s,r,a,!1),this.hoverCard=new la(n,s,r,a,!0),this.hoverCard.root.classList.add("hover-card"),this.hoverCard.root.hidden=!0;let l=L("aside",{class:"side","aria-label":"Details"});this.grid=L("div",{class:"grid"});let c=L("div",{class:"lower"},this.plots.root),h=L("div",{class:"middle"},this.viewport,this.transport.root);this.grid.append(this.text.root,tp("Width of the program text","column",this.grid,"--text-width",150,900),h,l,tp("Height of the plots","row",this.grid,"--plots-height",90,620),c),e.append(this.header(),this.grid),document.body.classList.add("app"),this.stage=new Eu(n,this.viewport,{hover:(m,v,g)=>{this.hoverPlace=m===null?null:{x:v,y:g},this.hover.set(m),this.placeHoverCard()},click:m=>{this.timeline.pause(),this.timeline.seek(m)}},this.colouring,o,t.simulation),this.viewport.append(this.viewTools(),this.restTools(),...this.stockTools(),this.hoverCard.root),this.position=new su(n,this.timeline,this.stage,new wl(n,r)),this.machine=new Bh(n,a);let u={colour:m=>this.setColouring(m),hold:m=>this.setFixed(m)};this.display=new Cl(this.colourings,this.stage,u,n.head.path.rapids_apart);let d={seek:m=>this.jump(m),showLine:m=>this.showLine(m)};this.findings=new Uh(n,d),this.operations=new Oh(n,d,o);let f=(m,v,g)=>this.showPlace(m,v,g);this.simulation=t.simulation&&new iu(t.simulation,{showPlace:f},o),this.fillSide(l),new Al(this.commands()),this.timeline.onChange(()=>this.update()),this.hover.onChange(()=>this.showHover()),this.theme.onChange(()=>this.restyle()),this.display.showColouring(this.colouring,o),this.openSheet(n.head.findings.length>0?"findings":this.simulation?"simulation":"now"),this.showChoices(),this.update(),this.started=!0,this.stage.lookFirst()}data;timeline;stage;colourings;colouring;theme=new Dh;hover=new lu;text;plots;position;machine;display;findings;operations;simulation;transport;blockCard;hoverCard;viewport=L("div",{id:"viewport",class:"viewport"});sheets=new Map;sheetTabs=new Map;grid;hoverPlace=null;shownPoint=-1;started=!1;setColouring(t){let e=this.colourings.find(n=>n.name===t);if(!e)throw new Error(`no colouring \`${t}\`; there are ${this.colourings.map(n=>n.name).join(", ")}`);this.colouring=e,this.stage.colour(e),this.display.showColouring(e,this.theme.theme)}setFixed(t){this.stage.setFixed(t),this.showChoices()}select(t){let e=this.data.program.pointOfLine(t);e!==null&&this.jump(e)}showLine(t){let{program:e}=this.data,n=this.exactPointOfLine(t);this.jump(n??e.pointBefore(t)),n===null&&(this.text.setCurrent(t),this.blockCard.showLine(t))}setStock(t){this.stage.setStock(t),this.showChoices()}showPlace(t,e,n){t!==null&&this.showLine(t);let s=this.data.program.placementAt(this.timeline.point);this.stage.markPlace(e,n?null:s.set_up)}drawnTip(){return this.stage.machine.drawnTip()}jump(t){this.timeline.pause(),this.timeline.seek(t)}exactPointOfLine(t){let e=this.data.program.pointOfLine(t);return e!==null&&this.data.program.line[e]===t?e:null}update(){let{point:t,position:e}=this.timeline,{program:n}=this.data;this.stage.seek(e),this.position.update(),this.machine.update(e),this.plots.update(),(t!==this.shownPoint||this.text.currentLine!==n.line[t])&&(this.shownPoint=t,this.text.setCurrent(n.line[t],this.started),this.operations.update(t),this.blockCard.show(t))}showHover(){let{point:t}=this.hover;this.stage.hover(t),this.text.setHover(t===null?null:this.data.program.line[t]),t!==null&&this.hoverCard.show(t),this.placeHoverCard()}placeHoverCard(){let t=this.hoverCard.root;if(t.hidden=this.hoverPlace===null||this.hover.point===null,this.hoverPlace===null||t.hidden)return;let{width:e,height:n}=this.stage.view.size,s=this.hoverPlace.x<e/2?e-t.offsetWidth-8:8,r=n-t.offsetHeight-8;t.style.transform=`translate(${s.toFixed(0)}px, ${Math.max(r,8).toFixed(0)}px)`}restyle(){let{theme:t}=this.theme;this.stage.restyle(t),this.display.showColouring(this.colouring,t),this.plots.restyle(t),this.transport.restyle(t),this.operations.restyle(t),this.simulation?.restyle(t),this.text.restyle()}header(){let{head:t}=this.data.program,e=L("h1",{},t.program),n=L("p",{},`${t.machine.name} \xB7 ${t.control} \xB7 from ${t.cl}`),s=t.findings.length,r=L("button",{type:"button",class:s>0?"badge bad":"badge good"},s>0?`${s} finding${s>1?"s":""}`:"agrees with the CL data");r.title="for the machine of the tab Machine: signs and centre lines must be compared with the real one",r.addEventListener("click",()=>this.openSheet(s>0?"findings":"machine"));let o=t.warnings.length,a=L("button",{type:"button",class:"badge warn"},`${o} warning${o>1?"s":""}`);a.addEventListener("click",()=>this.openSheet("findings"));let l=this.simulationBadge(),c=dn({label:"Summary",key:"S",id:"summary-toggle",press:()=>this.toggleSummary()});return c.setAttribute("aria-pressed","false"),L("header",{class:"top"},L("div",{class:"title"},e,n),r,...l?[l]:[],...o>0?[a]:[],L("span",{class:"stretch"}),c,dn({label:"Light or dark",icon:ls("M10 3a7 7 0 1 0 7 7 5.5 5.5 0 0 1-7-7z"),key:"D",press:()=>this.theme.toggle()}),dn({label:"Keys",icon:ls("M7.3 7.2a2.8 2.8 0 1 1 3.9 2.6c-.8.4-1.2.9-1.2 1.9M10 14.6v.6"),key:"?",press:()=>this.keyboardHelp()}))}simulationBadge(){let t=this.data.simulation?.figures;if(!t)return null;let{collisions:e,design:n}=t,s=n?.gouge_count??0,r=(l,c)=>`${l===0?"no":l} ${c}${l===1?"":"s"}`,o=[r(e,"collision"),...n?[r(s,"gouge")]:[]].join(", "),a=L("button",{type:"button",class:e+s>0?"badge bad":"badge good"},o);return a.title=this.data.simulation?.line??"",a.addEventListener("click",()=>this.openSheet("simulation")),a}keyboardHelp(){let t=document.getElementById("help-dialog");t instanceof HTMLDialogElement&&t.showModal()}toggleSummary(){let t=document.body.classList.toggle("show-summary");this.timeline.pause(),document.getElementById("summary-toggle")?.setAttribute("aria-pressed",String(t)),this.stage.view.request()}viewTools(){let t=L("div",{class:"view-tools",role:"toolbar","aria-label":"Views"});t.append(dn({label:"Fit the path",icon:ls(Au.fit),key:"F",press:()=>this.stage.fit(!1)}),dn({label:"Fit the machine",icon:ls(Au.machine),key:"Shift+F",press:()=>this.stage.fit(!0)}),dn({label:"Isometric",icon:ls(Au.iso),key:"1",press:()=>this.stage.look("iso")}),dn({label:"Along the tool axis",icon:ls(Au.tool),key:"8",press:()=>this.stage.lookAlongTool()}));for(let e of["top","front","right"]){let{label:n,key:s}=Ko[e];t.append(dn({label:n,key:s,press:()=>this.stage.look(e)}))}return t}restTools(){let t=L("div",{class:"rest-tools",role:"group","aria-label":"At rest"});for(let[e,n]of[["machine","Machine"],["part","Part"]]){let s=dn({label:n,press:()=>this.setFixed(e)});s.title=`${n} at rest (B)`,s.dataset.fixed=e,t.append(s)}return t}stockTools(){let{simulated:t}=this.stage;if(!t)return[];let e=L("div",{class:"rest-tools stock-tools",role:"group","aria-label":"Stock"}),n=[["result","Machined stock"],["cut","As it is cut"],["off","No stock"]];for(let[s,r]of n){if(s==="cut"&&!t.hasStages)continue;let o=dn({label:r,press:()=>this.setStock(s)});o.title=`${r} (G)`,o.dataset.stock=s,e.append(o)}return[e]}showChoices(){this.display.update();for(let t of this.viewport.querySelectorAll("[data-fixed]"))t.setAttribute("aria-pressed",String(t.dataset.fixed===this.stage.fixed));for(let t of this.viewport.querySelectorAll("[data-stock]"))t.setAttribute("aria-pressed",String(t.dataset.stock===this.stage.simulated?.stock))}fillSide(t){let e={now:[this.position.root,L("section",{class:"panel","aria-label":"Block"},L("h2",{},"Block"),this.blockCard.root)],machine:[this.machine.root],display:[this.display.root],findings:[this.findings.root],simulation:this.simulation?[this.simulation.root]:[],operations:[this.operations.root]},n=C_.filter(r=>e[r].length>0),s=L("div",{class:"tabs",role:"tablist","aria-label":"Details"});for(let r of n){let o=L("button",{type:"button",role:"tab",id:`tab-${r}`,"aria-controls":`sheet-${r}`},WT[r]);o.addEventListener("click",()=>this.openSheet(r)),o.addEventListener("keydown",l=>{let c={ArrowRight:1,ArrowLeft:-1}[l.key];if(c===void 0)return;l.preventDefault(),l.stopPropagation();let h=n[(n.indexOf(r)+c+n.length)%n.length];this.openSheet(h),this.sheetTabs.get(h)?.focus()});let a=L("div",{class:"sheet",role:"tabpanel",id:`sheet-${r}`,"aria-labelledby":`tab-${r}`,tabindex:"0"},...e[r]);this.sheets.set(r,a),this.sheetTabs.set(r,o),s.append(o),t.append(a)}t.prepend(s),this.openSheet("now")}openSheet(t){for(let e of C_){let n=e===t,s=this.sheetTabs.get(e),r=this.sheets.get(e);!s||!r||(r.hidden=!n,s.setAttribute("aria-selected",String(n)),s.tabIndex=n?0:-1)}}nextColouring(t){let e=(this.colourings.indexOf(this.colouring)+t+this.colourings.length)%this.colourings.length;this.setColouring(this.colourings[e].name),this.openSheet("display")}commands(){let{timeline:t,stage:e}=this,n=(r,o)=>r[(r.indexOf(o)+1)%r.length],s=r=>()=>{r(),this.showChoices()};return[{title:"Playback",commands:[{keys:[" "],label:"play or pause",run:()=>t.toggle()},{keys:["ArrowRight"],label:"next block",run:()=>t.stepBlock(1)},{keys:["ArrowLeft"],label:"previous block",run:()=>t.stepBlock(-1)},{keys:["Shift+ArrowRight"],label:"next point",run:()=>t.stepPoint(1)},{keys:["Shift+ArrowLeft"],label:"previous point",run:()=>t.stepPoint(-1)},{keys:["PageDown"],label:"next operation",run:()=>t.stepOperation(1)},{keys:["PageUp"],label:"previous operation",run:()=>t.stepOperation(-1)},{keys:["Home"],label:"first point",run:()=>this.jump(0)},{keys:["End"],label:"last point",run:()=>this.jump(this.data.program.count-1)},{keys:["+","="],shown:"+",label:"faster",run:()=>t.stepPace(1)},{keys:["-"],shown:"\u2212",label:"slower",run:()=>t.stepPace(-1)}]},{title:"View",commands:[{keys:["f"],label:"fit the path",run:()=>e.fit(!1)},{keys:["Shift+f"],label:"fit the machine",run:()=>e.fit(!0)},...Object.keys(Ko).map(r=>({keys:[Ko[r].key],label:Ko[r].label.toLowerCase(),run:()=>e.look(r)})),{keys:["8"],label:"along the tool axis",run:()=>e.lookAlongTool()},{keys:["t"],label:"centre on the tool",run:()=>e.centreOnTool()},{keys:[","],label:"zoom out",run:()=>e.view.zoomBy(.8)},{keys:["."],label:"zoom in",run:()=>e.view.zoomBy(1.25)},{keys:["i"],label:"orbit up",run:()=>e.view.orbitBy(0,.13)},{keys:["k"],label:"orbit down",run:()=>e.view.orbitBy(0,-.13)},{keys:["j"],label:"orbit left",run:()=>e.view.orbitBy(-.13,0)},{keys:["o"],label:"orbit right",run:()=>e.view.orbitBy(.13,0)},...[["Shift+i","up",0,-1],["Shift+k","down",0,1],["Shift+j","left",1,0],["Shift+o","right",-1,0]].map(([r,o,a,l])=>({keys:[r],label:`pan ${o}`,run:()=>e.view.panBy(40*a,40*l)}))]},{title:"Display",commands:[{keys:["c"],label:"next colouring",run:()=>this.nextColouring(1)},{keys:["Shift+c"],label:"previous colouring",run:()=>this.nextColouring(-1)},{keys:["a"],label:"tool axis ticks",run:()=>e.layers.toggle("ticks")},{keys:["l"],label:"axis arrows",run:()=>e.layers.toggle("arrows")},{keys:["b"],label:"part or bed at rest",run:()=>this.setFixed(n(["part","machine"],e.fixed))},{keys:["m"],label:"bodies: solid, clear, off",run:s(()=>e.setMachineStyle(n(["solid","ghost","off"],e.machineStyle)))},{keys:["h"],label:"path: all, done, operation",run:s(()=>e.setExtent(n(["whole","done","operation"],e.extent)))},...this.data.simulation?[{keys:["g"],label:"stock: machined, as it is cut, none",run:()=>this.setStock(n(["result","cut","off"],e.simulated?.stock??"off"))},{keys:["e"],label:"design",run:()=>e.layers.toggle("design")}]:[],{keys:["d"],label:"light or dark",run:()=>this.theme.toggle()},{keys:["s"],label:"summary",run:()=>this.toggleSummary()}]},{title:"Text and plots",commands:[{keys:["/"],label:"search; :120 is line 120",run:()=>this.text.searchField.focus()},{keys:["n"],label:"next finding",run:()=>this.findings.step(1,this.text.currentLine)},{keys:["Shift+n"],label:"previous finding",run:()=>this.findings.step(-1,this.text.currentLine)},...this.simulation?[{keys:["v"],label:"next finding of the simulation",run:()=>this.simulation?.step(1)},{keys:["Shift+v"],label:"previous finding of the simulation",run:()=>this.simulation?.step(-1)}]:[],{keys:["p"],label:"next plots",run:()=>this.plots.nextTab()},{keys:["x"],label:"plots over time or blocks",run:()=>this.plots.toggleAxis()},{keys:["["],label:"plots: zoom in",run:()=>this.plots.zoomBy(.5)},{keys:["]"],label:"plots: zoom out",run:()=>this.plots.zoomBy(2)},{keys:["\\"],label:"plots: all",run:()=>this.plots.setZoom(null)}]}]}};var R_={f32:4,u16:2,u8:1,q32:4};function XT(i){let t=atob(i),e=new Uint8Array(t.length);for(let n=0;n<t.length;n+=1)e[n]=t.charCodeAt(n);return e}async function jo(i,t){let e=XT(i);if(!t)return e;let n=new Blob([e]).stream().pipeThrough(new DecompressionStream("deflate-raw"));return new Uint8Array(await new Response(n).arrayBuffer())}function ep(i){try{return new TextDecoder("utf-8",{fatal:!0}).decode(i)}catch{return new TextDecoder("latin1").decode(i)}}function Ru(i,t){let e=i.columns.reduce((r,o)=>r+R_[o.type]*i.points,0);if(t.byteLength!==e)throw new Error(`the columns have ${t.byteLength} bytes, expected ${e} for ${i.points} points`);let n=new Map,s=0;for(let r of i.columns){let o=s+R_[r.type]*i.points;n.set(r.name,$T(r,qT(t.subarray(s,o),i.points),i.points)),s=o}return n}function qT(i,t){let e=t>0?i.length/t:0,n=new Uint8Array(i.length);for(let s=0;s<e;s+=1)for(let r=0;r<t;r+=1)n[r*e+s]=i[s*t+r];return new DataView(n.buffer)}function $T(i,t,e){let n=new Float64Array(e);switch(i.type){case"f32":for(let s=0;s<e;s+=1)n[s]=t.getFloat32(4*s,!0);break;case"u16":for(let s=0;s<e;s+=1)n[s]=t.getUint16(2*s,!0);break;case"u8":for(let s=0;s<e;s+=1)n[s]=t.getUint8(s);break;case"q32":{let s=i.scale??1,r=0;for(let o=0;o<e;o+=1)r+=t.getInt32(4*o,!0),n[o]=r*s;break}}return n}async function np(i){return Ru({columns:i.columns,points:i.rows},await jo(i.data,!0))}function ip(i,t){let e=i.get(t);if(!e)throw new Error(`the simulation has no column \`${t}\``);return e}async function YT(i){let t=await np(i.vertices),e=await np(i.faces);return{name:i.name,role:i.role,link:i.link,setUps:i.set_ups,positions:Float32Array.from(P_(["x","y","z"].map(n=>ip(t,n)))),faces:Uint32Array.from(P_(["a","b","c"].map(n=>ip(e,n)))),deviations:t.get("value")??null,lines:t.get("line")??null}}function P_(i){let t=new Float64Array(i.length*i[0].length);return i.forEach((e,n)=>{for(let s=0;s<e.length;s+=1)t[s*i.length+n]=e[s]}),t}async function L_(i){let t=await np(i),[e,n,s,r]=["stock_line","low","high","line"].map(o=>ip(t,o));return{stockLine:e,low:n,high:s,line:r}}async function ZT(i){return{setUp:i.set_up,corners:i.corners,counts:i.counts,material:await L_(i.material),removed:await L_(i.removed)}}async function I_(i){let t=JSON.parse(i);if(t.format!==1)throw new Error(`this page reads simulations of format 1, and its data has format ${String(t.format)}`);return{line:t.line,figures:t.figures,bodies:await Promise.all(t.bodies.map(YT)),tools:new Map(t.tools),linkPlaces:t.link_places,partPlaces:t.part_places,stages:t.stages?await Promise.all(t.stages.map(ZT)):null}}function _l(i){let t=document.getElementById(i);if(!t)return null;let e=t.textContent??"";return t.textContent="",e}async function D_(){let i=_l("program-head"),t=_l("program-columns"),e=_l("program-text");if(i===null||t===null||e===null)throw new Error("this page has no program: its data elements are missing");let n=JSON.parse(i);if(n.format!==1)throw new Error(`this page reads format 1, and its data has format ${String(n.format)}`);let s=Ru(n,await jo(t,n.compressed)),r=_l("cl-text"),o=_l("simulation");return{program:new Ts(n,s),programText:new fl(ep(await jo(e,n.compressed))),clText:r===null?null:new fl(ep(await jo(r,n.compressed))),simulation:o===null?null:await I_(o)}}async function KT(){let i=performance.now(),t=document.getElementById("app");if(!t)return;let e=await D_(),{program:n}=e;if(n.count===0){t.append(L("p",{class:"failure"},"The program has no motion to show; the summary is below."));return}let s=new Cu(e,t),r=performance.now()-i;window.ppView={head:n.head,ready:!0,get point(){return s.timeline.point},colourings:s.colourings.map(o=>o.name),loadMilliseconds:r,state:()=>({axes:n.axesBetween(s.timeline.position),tip:n.tipAt(s.timeline.point),toolTip:s.stage.machine.drawnTip(),joints:s.stage.machine.drawnJoints(),line:n.line[s.timeline.point],point:s.timeline.point,position:s.timeline.position,setUp:n.placementAt(s.timeline.point).set_up,colouring:s.colouring.name,playing:s.timeline.playing,simulation:s.stage.simulated&&{stock:s.stage.simulated.stock,volume:s.stage.simulated.volume(),origins:s.stage.simulated.origins()}}),seek:o=>s.timeline.seek(o),select:o=>s.select(o),play:()=>s.timeline.play(),pause:()=>s.timeline.pause(),setColouring:o=>s.setColouring(o),setMode:o=>s.setFixed(o),setStock:o=>s.setStock(o),frameMilliseconds:()=>s.stage.view.frameMilliseconds(),pick:(o,a)=>s.stage.pickAt(o,a)}}KT().catch(i=>{document.body.classList.remove("app");let t=i instanceof Error?i.message:String(i),e=L("p",{class:"failure",role:"alert"},`The interactive page could not start: ${t}. The summary is below.`);document.getElementById("app")?.replaceChildren(),document.body.prepend(e),console.error(i)});})();
