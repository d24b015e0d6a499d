//! Flies the crate `tello`. With HOST and PORT as arguments, the drone is there.

use std::io::{stdin, BufRead};
use std::time::{Duration, Instant};
use tello::{Drone, Message, Package, PackageData, ResponseMsg};

/// What the drone has told so far.
#[derive(Default)]
struct Told {
    connected: bool,
    version: String,
    height: i16,
    battery: u8,
    on_ground: bool,
    mode: u8,
    flights: u32,
    logs: u32,
    frames: u32,
}

fn take(told: &mut Told, message: Message) {
    match message {
        Message::Response(ResponseMsg::Connected(_)) => told.connected = true,
        Message::Frame(_, _) => told.frames += 1,
        Message::Data(Package { data: PackageData::FlightData(flight), .. }) => {
            told.height = flight.height;
            told.battery = flight.battery_percentage;
            told.on_ground = flight.em_ground;
            told.mode = flight.fly_mode;
            told.flights += 1;
        }
        Message::Data(Package { data: PackageData::Version(version), .. }) => told.version = version,
        Message::Data(Package { data: PackageData::LogMessage(_), .. }) => told.logs += 1,
        _ => (),
    }
}

/// Polls until something holds, but not longer than some seconds.
fn poll(drone: &mut Drone, told: &mut Told, seconds: f64, holds: impl Fn(&Told) -> bool) -> bool {
    let end = Instant::now() + Duration::from_secs_f64(seconds);
    while !holds(told) && Instant::now() < end {
        match drone.poll() {
            Some(message) => take(told, message),
            None => std::thread::sleep(Duration::from_millis(2)),
        }
    }
    holds(told)
}

/// Reports a step to the runner, with what it expects; see steps.py.
fn report(command: &str, reply: &str, expected: &str) {
    println!("step {{\"command\": \"{command}\", \"reply\": \"{reply}\", {expected}}}");
    let mut answer = String::new();
    if stdin().lock().read_line(&mut answer).unwrap_or(0) == 0 {
        panic!("the runner is gone");
    }
}

fn holds(command: &str, value: bool) {
    report(command, &value.to_string(), "\"want\": \"true\"");
}

fn moved(command: &str, direction: &str, least: i32, most: i32) {
    let free = format!("{{\"direction\": \"{direction}\", \"least\": {least}, \"most\": {most}}}");
    report(command, "", &format!("\"want\": \"\", \"free\": {free}"));
}

fn main() {
    let given: Vec<String> = std::env::args().skip(1).collect();
    let (host, port) = match &given[..] {
        [host, port, ..] => (host.as_str(), port.as_str()),
        _ => ("192.168.10.1", "8889"),
    };
    let mut drone = Drone::new(&format!("{host}:{port}"));
    let mut told = Told::default();
    drone.connect(11111);
    holds("connect", poll(&mut drone, &mut told, 5.0, |told| told.connected));
    holds("battery", poll(&mut drone, &mut told, 2.0, |told| told.battery == 100));
    holds("version", poll(&mut drone, &mut told, 5.0, |told| !told.version.is_empty()));
    holds("frames", poll(&mut drone, &mut told, 10.0, |told| told.frames >= 30));
    holds("log", poll(&mut drone, &mut told, 5.0, |told| told.logs > 0));
    let before = told.logs; // the header comes once more only if its answer was not understood
    poll(&mut drone, &mut told, 5.0, |_| false);
    holds("log answered", told.logs == before);

    drone.take_off().unwrap();
    let hovers = poll(&mut drone, &mut told, 10.0, |told| told.mode == 6);
    moved("takeoff", "up", 20, 100);
    holds("hovers", hovers);
    drone.rc_state.go_forward_back(0.5);
    poll(&mut drone, &mut told, 2.0, |_| false);
    drone.rc_state.go_forward_back(0.0);
    poll(&mut drone, &mut told, 2.0, |_| false);
    moved("forward", "forward", 20, 300);
    drone.land().unwrap();
    let stands = poll(&mut drone, &mut told, 10.0, |told| told.on_ground);
    moved("land", "down", 20, 100);
    holds("stands", stands);
    println!("done");
}
