'use strict';
// Ten commands with tellojs over a link that fails: each again until the drone has carried it out.

const { control, receiver } = require('tellojs');
const { move, rotate } = control;

const TRIES = 12;
const PAUSE_MS = 2000; // for what is still on its way, or still being flown
const LONGER_MS = 300; // each time, or every try may come just before the drone has settled

const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

let latest = {};
receiver.state.bind().on('message', (state) => { latest = state; });

/** Calls until the drone answers `ok`, or `done` says that it had done it before. */
async function persist(name, call, done = () => false) {
    for (let i = 0; i < TRIES; i++) {
        const reply = await call().then((text) => text, (reason) => String(reason));
        if (reply === 'ok' || done(reply)) {
            return;
        }
        await pause(PAUSE_MS + i * LONGER_MS);
        if (name !== 'takeoff' && name !== 'land' && reply.includes('Motor stop')) {
            await takeOff(); // it has landed by itself, as nothing came for 15 s
        }
    }
    console.log(`${name} failed ${TRIES} times`);
    process.exit(1);
}

const takeOff = () => persist('takeoff', control.takeOff, () => latest.tof > 20);

async function main() {
    await persist('command', control.connect);
    await takeOff();
    await persist('up 30', () => move.up(30));
    await persist('forward 50', () => move.front(50));
    await persist('cw 90', () => rotate.clockwise(90));
    await persist('left 30', () => move.left(30));
    await persist('right 30', () => move.right(30));
    await persist('ccw 90', () => rotate.counterClockwise(90));
    await persist('back 50', () => move.back(50));
    await persist('land', control.land, (reply) => reply.includes('Motor stop'));
    console.log('done');
    process.exit(0);
}

main();
