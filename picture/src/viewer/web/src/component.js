// The solver: the core module of the FMU's component, called by the canonical ABI of the component model. The functions and their
// types are those of the WIT of FMI-LS-WASM (`fmu/wit`); here are the few that a page needs.

const INTERFACE = "fmi:fmi3/co-simulation@3.0.0";
const RESOURCE = "co-simulation-instance";
const [OK, WARNING] = [0, 1];

/** A call that was refused, in the words of the component. */
export class Refused extends Error {}

export class Fmu {
  /** An instance of a compiled module. */
  constructor(module, name, token) {
    this.messages = [];
    /** Warnings since somebody took them. */
    this.warnings = [];
    const text = (at, length) => new TextDecoder().decode(new Uint8Array(this.core.memory.buffer, at, length));
    const log = (_name, _length, status, _category, _extent, at, length) => {
      (status === WARNING ? this.warnings : this.messages).push(text(at, length));
    };
    // An instance is its own handle: there is one, and it ends with the module.
    const resources = { [`[resource-new]${RESOURCE}`]: (own) => own, [`[resource-drop]${RESOURCE}`]: () => {} };
    const updates = () => {
      throw new Refused("the component asked for an intermediate update, which this page has not offered");
    };
    this.core = new WebAssembly.Instance(module, {
      [`[export]${INTERFACE}`]: resources,
      "fmi:fmi3/callbacks@3.0.0": { "log-message": log },
      "fmi:fmi3/intermediate-update-callbacks@3.0.0": { "intermediate-update": updates },
    }).exports;
    const texts = [name, token, ""].flatMap((own) => this.list(new TextEncoder().encode(own)));
    const at = this.core[`${INTERFACE}#[static]${RESOURCE}.instantiate-co-simulation`](...texts, 0, 0, 0, 0, ...this.list(new Uint32Array()));
    const view = this.view();
    if (!view.getUint8(at)) this.refuse("instantiate");
    this.own = view.getInt32(at + 4, true);
  }

  view() {
    return new DataView(this.core.memory.buffer);
  }

  /** Place and length of a copy of numbers in the module's memory; who is called frees it. */
  list(numbers) {
    const at = this.core.cabi_realloc(0, 0, numbers.BYTES_PER_ELEMENT, numbers.byteLength) >>> 0;
    new numbers.constructor(this.core.memory.buffer, at, numbers.length).set(numbers);
    return [at, numbers.length];
  }

  refuse(name) {
    const said = this.messages.join("\n");
    throw new Refused(said || `${name} failed without a message`);
  }

  invoke(name, ...numbers) {
    this.messages = [];
    return this.core[`${INTERFACE}#[method]${RESOURCE}.${name}`](this.own, ...numbers);
  }

  /** A function that answers with its status. */
  call(name, ...numbers) {
    if (![OK, WARNING].includes(this.invoke(name, ...numbers))) this.refuse(name);
  }

  start() {
    this.call("enter-initialization-mode", 0, 0, 0, 0, 0);
    this.call("exit-initialization-mode");
  }

  /** The elements of variables, one after the other. */
  read(name, Kind, references) {
    const at = this.invoke(name, ...this.list(Uint32Array.from(references)));
    const view = this.view();
    if (view.getUint8(at)) this.refuse(name);
    const found = new Kind(this.core.memory.buffer, view.getUint32(at + 4, true), view.getUint32(at + 8, true)).slice();
    this.core[`cabi_post_${INTERFACE}#[method]${RESOURCE}.${name}`](at);
    return found;
  }

  getFloat64(references) {
    return this.read("get-float64", Float64Array, references);
  }

  getInt32(references) {
    return this.read("get-int32", Int32Array, references);
  }

  getBoolean(references) {
    return this.read("get-boolean", Uint8Array, references);
  }

  /** The bytes of one variable. */
  getBinary(reference) {
    const name = "get-binary";
    const at = this.invoke(name, ...this.list(Uint32Array.of(reference)));
    const view = this.view();
    if (view.getUint8(at)) this.refuse(name);
    const first = view.getUint32(at + 4, true);
    const found = new Uint8Array(this.core.memory.buffer, view.getUint32(first, true), view.getUint32(first + 4, true)).slice();
    this.core[`cabi_post_${INTERFACE}#[method]${RESOURCE}.${name}`](at);
    return found;
  }

  setFloat64(references, values) {
    this.call("set-float64", ...this.list(Uint32Array.from(references)), ...this.list(Float64Array.from(values)));
  }

  /** A communication step [s]; answers whether the FMU asks to end. */
  doStep(time, step) {
    const at = this.invoke("do-step", time, step, 0);
    const view = this.view();
    if (view.getUint8(at)) this.refuse("do-step");
    return Boolean(view.getUint8(at + 17));
  }
}
