// The shim for Node.js: sockets of dgram find simulated drones at the addresses of real ones.
'use strict';

const dgram = require('dgram');

const PROGRAM = '192.168.10.2'; // the address of a machine that has joined the drone's network

const simulated = new Map();
const real = new Map();
for (const pair of (process.env.TELLO_SIMULATOR_SHIM || '').split(',').filter(Boolean)) {
  const [drone, simulator] = pair.split('=');
  simulated.set(drone, simulator);
  real.set(simulator, drone);
}

function translated(addresses, address, port) {
  const found = addresses.get(`${address}:${port}`);
  if (!found) {
    return { address, port };
  }
  const [host, number] = found.split(':');
  return { address: host, port: Number(number) };
}

const socket = dgram.Socket.prototype;
const { bind, connect, emit, remoteAddress, send } = socket;

// send(msg[, offset, length][, port][, address][, callback])
socket.send = function (...words) {
  const at = Number.isInteger(words[1]) && Number.isInteger(words[2]) && words.length > 3 ? 3 : 1;
  if (typeof words[at + 1] === 'string') {
    const { address, port } = translated(simulated, words[at + 1], words[at]);
    words.splice(at, 2, port, address);
  }
  return send.apply(this, words);
};

// connect(port[, address][, callback])
socket.connect = function (port, address, ...rest) {
  if (typeof address !== 'string') {
    return connect.call(this, port, address, ...rest);
  }
  const to = translated(simulated, address, port);
  return connect.call(this, to.port, to.address, ...rest);
};

// bind([port][, address][, callback]) or bind(options[, callback])
socket.bind = function (...words) {
  if (words[1] === PROGRAM) {
    words[1] = '0.0.0.0';
  } else if (words[0] && words[0].address === PROGRAM) {
    words[0] = { ...words[0], address: '0.0.0.0' };
  }
  return bind.apply(this, words);
};

socket.remoteAddress = function () {
  const peer = remoteAddress.call(this);
  return { ...peer, ...translated(real, peer.address, peer.port) };
};

socket.emit = function (event, ...values) {
  const sender = values[1];
  if (event === 'message' && sender) {
    Object.assign(sender, translated(real, sender.address, sender.port));
  }
  return emit.call(this, event, ...values);
};
