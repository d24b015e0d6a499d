'use strict';
// Flies tellojs. With HOST and PORT as arguments, the drone is there; without, where it always is.

const readline = require('readline');

const [host, port] = process.argv.slice(2);
if (host) {
    // Its constants are a module that all of its modules share; it has no option for them.
    const constants = require('tellojs/src/constants.json');
    constants.hosts.remote = host;
    constants.ports.command = Number(port);
}
const { control, read, set, receiver } = require('tellojs');
const { move, rotate, flip } = control;

const answers = readline.createInterface({ input: process.stdin })[Symbol.asyncIterator]();
const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/** Tells the runner, which judges the reply and where the drone is, and answers with its pose. */
async function report(command, reply, expected = { want: 'ok' }) {
    const step = { command, reply: String(reply), ...expected };
    process.stdout.write(`step ${JSON.stringify(step)}\n`);
    return JSON.parse((await answers.next()).value);
}

/** What the client resolves with; it rejects nothing but a bare `error` and its own time-out. */
const answered = (promise) => promise.then((text) => text, (reason) => `rejected: ${reason}`);

const fly = async (command, promise, expected) =>
    report(command, await answered(promise), expected);

const want = (text) => ({ want: text });
const like = (pattern) => ({ pattern });
const near = (value, tolerance) => ({ near: [value, tolerance] });

let latest;
receiver.state.bind().on('message', (state) => { latest = state; });

async function state(pose) {
    await pause(300);
    await report('state.battery', latest.battery, near(pose.battery, 1));
    await report('state.heigh', latest.heigh, near(pose.z, 10));
    await report('state.tof', latest.tof, near(Math.max(pose.z, 10), 2));
    await report('state.yaw', latest.yaw, near(pose.yaw, 1));
}

async function reads() {
    await fly('battery?', read.battery(), like('(100|9\\d)\r\n'));
    await fly('speed?', read.speed(), want('100.0\r\n'));
    await fly('time?', read.time(), want('0s\r\n'));
    await fly('height?', read.height(), want('0dm\r\n'));
    await fly('temp?', read.temperature(), like('\\d+~\\d+C\r\n'));
    await fly('attitude?', read.attitude(), want('pitch:0;roll:0;yaw:0;\r\n'));
    await fly('baro?', read.barometer(), like('-?\\d+\\.\\d{6}\r\n'));
    await fly('tof?', read.tof(), like('\\d+mm\r\n'));
    await fly('wifi?', read.wifi(), like('\\d+\r\n'));
}

async function moves() {
    await fly('up 90', move.up(90));
    await fly('forward 60', move.front(60));
    await fly('left 70', move.left(70));
    await state(await fly('cw 60', rotate.clockwise(60)));
    await fly('back 30', move.back(30));
    await fly('ccw 150', rotate.counterClockwise(150));
    await fly('right 45', move.right(45));
    await fly('down 25', move.down(25));
    await fly('speed 90', set.speed(90));
    await fly('go -40 60 -30 50', control.go({ x: -40, y: 60, z: -30 }, 50));
    const curve = control.curve({ x: 60, y: 60, z: 0 }, { x: 0, y: 120, z: 0 }, 60);
    await fly('curve 60 60 0 0 120 0 60', curve);
    await fly('flip f', flip.front());
    await fly('flip r', flip.right());
}

async function refusalsInTheAir() {
    await fly('takeoff', control.takeOff(), want('rejected: error'));
    await fly('forward 0.2', move.front(0.2), want('out of range'));
    const tooNear = control.go({ x: 0, y: -12, z: 17 }, 20);
    await fly('go 0 -12 17 20', tooNear, want('out of range'));
    const straight = control.curve({ x: 0, y: 40, z: 0 }, { x: 0, y: 80, z: 0 }, 20);
    await fly('curve 0 40 0 0 80 0 20', straight, want('error Radius is too large!'));
    await fly('rc 0 0 101 0', set.rc(0, 0, 101, 0), want('out of range'));
}

/**
 * The client looks every 100 ms at the last datagram. So either `forced stop` has already taken the
 * place of `ok`, or it waits there and makes the client refuse the next command, which is sent
 * nevertheless; with that, the client is in step again.
 */
async function stop() {
    const reply = await answered(control.stop());
    await report('stop', reply, like('ok|forced stop'));
    await pause(400);
    const next = reply === 'ok' ? want('rejected: error') : like('\\d+\r\n');
    await fly('battery?', read.battery(), next);
    await pause(200);
}

/**
 * The client waits 10 s for the answer to `rc`, which the drone never gives. At five times the speed
 * that is longer than a drone keeps flying without a command, so that it lands by itself.
 */
async function stick() {
    const far = { direction: 'forward', least: 200, most: 800 };
    const late = { want: 'rejected: error', free: far, lands: true };
    await fly('rc 0 25 0 0', set.rc(0, 25, 0, 0), late);
}

async function main() {
    await state(await fly('command', control.connect()));
    await reads();
    await fly('up 50', move.up(50), want('error Motor stop'));
    await fly('takeoff', control.takeOff());
    await moves();
    await refusalsInTheAir();
    await stop();
    await fly('back 40', move.back(40));
    await fly('land', control.land());
    await fly('land', control.land(), want('error Motor stop'));
    await fly('takeoff', control.takeOff());
    await stick();
    process.stdout.write('done\n');
    process.exit(0);
}

main();
