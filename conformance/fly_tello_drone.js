'use strict';
// Flies tello-drone, which always uses the address of a real drone.

const readline = require('readline');
const { connect } = require('tello-drone');

const answers = readline.createInterface({ input: process.stdin })[Symbol.asyncIterator]();

/** Tells the runner, which judges the reply and where the drone is, and answers with its pose. */
async function report(command, reply, expected = { want: 'ok' }) {
    const step = { command, reply: String(reply), ...expected };
    process.stdout.write(`step ${JSON.stringify(step)}\n`);
    return JSON.parse((await answers.next()).value);
}

const drone = connect();

const next = (event) => new Promise((resolve) => drone.events.once(event, resolve));

async function fly(command, options, expected) {
    const reply = next('message');
    drone.forceSend(command, options);
    const words = [command, ...Object.values(options || {})].join(' ');
    return report(words, await reply, expected);
}

async function main() {
    await next('connection');
    await report('command', 'ok');
    await fly('battery?', undefined, { pattern: '(100|9\\d)\r\n' });
    await fly('up', { value: 50 }, { want: 'error Motor stop' });
    await fly('takeoff');
    await fly('up', { value: 80 });
    await fly('forward', { value: 60 });
    await fly('left', { value: 70 });
    const pose = await fly('cw', { value: 60 });
    const state = await next('state');
    await report('state.yaw', state.yaw, { near: [pose.yaw, 1] });
    await report('state.bat', state.bat, { near: [pose.battery, 1] });
    await fly('back', { value: 30 });
    await fly('ccw', { value: 150 });
    await fly('right', { value: 45 });
    await fly('down', { value: 25 });
    await fly('speed', { value: 90 });
    await fly('go', { x: -40, y: 60, z: 30, speed: 50 });
    await fly('flip', { value: 'f' });
    await fly('takeoff', undefined, { want: 'error' });
    await fly('land');
    process.stdout.write('done\n');
    process.exit(0);
}

main();
